// A Chromium without a screen, spoken to through a pipe, and a server of files: nothing but Node.
import { spawn } from "node:child_process";
import { createReadStream, existsSync, mkdtempSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";

const KINDS = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };
const FLAGS = [
  "--headless", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync", "--remote-debugging-pipe", "--window-size=960,540",
  "--hide-scrollbars", "--autoplay-policy=no-user-gesture-required",
];

/** Serves a folder on a free port of this machine alone. Without their kinds all files are bytes. */
export async function serve(folder, kinds = KINDS) {
  const server = createServer((request, response) => {
    const file = join(folder, new URL(request.url, "http://x").pathname.replace(/\/$/, "/index.html"));
    if (!file.startsWith(folder) || !existsSync(file) || !statSync(file).isFile()) return void response.writeHead(404).end();
    response.writeHead(200, { "content-type": kinds[extname(file)] ?? "application/octet-stream" });
    createReadStream(file).pipe(response);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

export class Browser {
  constructor() {
    this.folder = mkdtempSync(join(tmpdir(), "resultant-web-"));
    const program = process.env.CHROMIUM ?? ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
    if (!program) throw new Error("there is no Chromium: .ci/run names the package");
    this.process = spawn(program, [...FLAGS, `--user-data-dir=${this.folder}`], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    [this.waiting, this.number, this.listeners, this.console] = [new Map(), 0, [], []];
    let rest = "";
    this.process.stdio[4].setEncoding("utf8").on("data", (text) => {
      const parts = (rest + text).split("\0");
      rest = parts.pop();
      parts.forEach((part) => this.take(JSON.parse(part)));
    });
  }

  take(message) {
    const waiting = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) waiting?.no(new Error(message.error.message));
    else waiting?.yes(message.result);
    const { method, params } = message;
    if (method === "Runtime.consoleAPICalled") this.console.push(params.args.map((arg) => arg.value ?? arg.description).join(" "));
    if (method === "Runtime.exceptionThrown") this.console.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    // The page's question before it is left.
    if (method === "Page.javascriptDialogOpening") this.send("Page.handleJavaScriptDialog", { accept: true }).catch(() => {});
    this.listeners.filter((listener) => listener.method === method).forEach((listener) => listener.heard(params));
  }

  send(method, params = {}) {
    const id = ++this.number;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId: this.session }) + "\0");
    return new Promise((yes, no) => this.waiting.set(id, { yes, no }));
  }

  /** Opens the one page. */
  async open() {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    this.session = (await this.send("Target.attachToTarget", { targetId, flatten: true })).sessionId;
    for (const part of ["Page", "Runtime"]) await this.send(`${part}.enable`);
    await this.send("Emulation.setDeviceMetricsOverride", { width: 960, height: 540, deviceScaleFactor: 1, mobile: false });
  }

  /** Runs before the scripts of every page from now on. */
  before(script) { return this.send("Page.addScriptToEvaluateOnNewDocument", { source: script }); }

  /** The page that is loaded next. */
  loaded() { return new Promise((heard) => this.listeners.push({ method: "Page.loadEventFired", heard })); }

  async go(address) {
    const loaded = this.loaded();
    await this.send("Page.navigate", { url: address });
    await loaded;
  }

  async ask(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async until(expression, seconds = 60) {
    const end = Date.now() + 1000 * seconds;
    for (;;) {
      const value = await this.ask(expression);
      if (value) return value;
      if (Date.now() > end) throw new Error(`${expression} is not so after ${seconds} s; the console says:\n${this.console.join("\n")}`);
      await new Promise((done) => setTimeout(done, 50));
    }
  }

  key(type, { key, code, number, text, modifiers = 0 }) {
    const kind = type === "keyDown" && !text ? "rawKeyDown" : type;
    return this.send("Input.dispatchKeyEvent", { type: kind, key, code, text, modifiers, windowsVirtualKeyCode: number });
  }

  async picture(file) { writeFileSync(file, Buffer.from((await this.send("Page.captureScreenshot")).data, "base64")); }

  async close() {
    const ended = new Promise((done) => this.process.on("exit", done));
    this.send("Browser.close").catch(() => {});
    setTimeout(() => this.process.kill("SIGKILL"), 5000).unref();
    await ended;
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 5 });
  }
}
