// Plays the page of target/web like a person would: level 2 by keys to success, the score saved, the page loaded again, the score there.
// The page's clock goes by hand, five ticks of the game a frame, so that the keys of a recorded flight fall on its ticks.
import { mkdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { Browser, serve } from "./browser.mjs";

const root = resolve(import.meta.dirname, "../..");
const out = join(root, "target/web-pictures");
const TICKS = 5, FRAME = 1000 * TICKS / 120;
const USER = "bob445";
// A clock that stands still until a step, and frames that come with one.
const CLOCK = `(() => {
  let now = 1000, waiting = [];
  performance.now = () => now;
  window.requestAnimationFrame = (frame) => waiting.push(frame);
  window.cancelAnimationFrame = () => { waiting = []; };
  window.step = (frames) => {
    for (let i = 0; i < frames; i++) { now += ${FRAME}; const due = waiting; waiting = []; due.forEach((frame) => frame(now)); }
  };
})()`;
// From the menu: More, its fourth button.
const SETTINGS = [...Array(4).fill("ArrowDown"), "Enter", ...Array(3).fill("ArrowDown"), "Enter"];
const letter = (text) => ({ key: text, code: /[0-9]/.test(text) ? `Digit${text}` : `Key${text.toUpperCase()}`, number: text.toUpperCase().charCodeAt(0), text });
const KEYS = {
  ShiftLeft: { key: "Shift", code: "ShiftLeft", number: 16 },
  Space: { key: " ", code: "Space", number: 32, text: " " },
  ArrowLeft: { key: "ArrowLeft", code: "ArrowLeft", number: 37 }, ArrowUp: { key: "ArrowUp", code: "ArrowUp", number: 38 },
  ArrowRight: { key: "ArrowRight", code: "ArrowRight", number: 39 }, ArrowDown: { key: "ArrowDown", code: "ArrowDown", number: 40 },
  F11: { key: "F11", code: "F11", number: 122 },
  Tab: { key: "Tab", code: "Tab", number: 9 },
  Enter: { key: "Enter", code: "Enter", number: 13, text: "\r" }, Escape: { key: "Escape", code: "Escape", number: 27 },
};
// In the order of a record's columns.
const STEER = ["Space", "ShiftLeft", "ArrowLeft", "ArrowRight"];
const check = (holds, words) => { if (!holds) throw new Error(words); };

const browser = new Browser();
const server = await serve(join(root, "target/web"));
const plain = await serve(join(root, "target/web"), { ".html": "text/html" });
try {
  mkdirSync(out, { recursive: true });
  await browser.open();
  const kept = (file) => browser.ask(`localStorage.getItem(${JSON.stringify(`resultant/${file}`)})`);
  const keepSettings = (rows) => browser.ask(`localStorage.setItem("resultant/settings.csv", ${JSON.stringify(`tsetting,value,player\n${rows}`)})`);
  const step = (frames = 1) => browser.ask(`step(${frames})`);
  const looks = async () => (await browser.send("Page.captureScreenshot")).data;
  const picture = (name) => browser.picture(join(out, `${name}.png`));
  async function begin(link = "") {
    await browser.go("about:blank");
    await browser.go(server.address + link);
    // The program is fetched and built, and its first frames come.
    await browser.until("typeof wasm_exports === 'object' && (step(1), !!window.resultantReady)");
    await step(30);
  }
  async function press(...names) {
    for (const name of names) {
      const key = KEYS[name] ?? letter(name);
      await browser.key("keyDown", key);
      await step(2);
      await browser.key("keyUp", key);
      await step(8);
    }
  }

  // A server that knows of no programs serves the page as well, and the console has no word.
  await browser.go(plain.address);
  await browser.until("window.resultantReady");
  check(browser.console.length === 0, `the console says: ${browser.console.join("\n")}`);

  // A lost context is named in the player's language.
  await keepSettings("language,de,\n");
  await browser.go("about:blank");
  await browser.go(plain.address);
  await browser.until("window.resultantReady");
  await browser.ask("gl.getExtension('WEBGL_lose_context').loseContext()");
  await browser.until("/Grafik weggenommen/.test(document.getElementById('words').innerText)", 10);
  await picture("lost-context");
  const fresh = browser.loaded();
  await browser.ask("localStorage.removeItem('resultant/settings.csv'), document.getElementById('words').click()");
  await fresh;
  await browser.until("window.resultantReady && document.getElementById('words').hidden");
  console.log("a lost context is named, and a click begins again");

  // By the browser's own clock: a menu that nobody touches draws at most 30 frames a second.
  await browser.go(server.address);
  await browser.until("window.resultantReady");
  const [frames, seconds] = await browser.ask(`new Promise((done) => setTimeout(() => {
    const [frames, begun] = [resultantFrames, performance.now()];
    setTimeout(() => done([resultantFrames - frames, (performance.now() - begun) / 1000]), 2000);
  }, 1500))`);
  console.log("the menu at rest:", (frames / seconds).toFixed(1), "frames a second");
  check(frames / seconds <= 32, "the menu draws more than 30 frames a second");

  await browser.before(CLOCK);
  await begin();
  await picture("menu");

  // F11 fills the screen. The browser's own Esc gives it back, and the next F11 fills it again.
  const filled = async (yes) => {
    await browser.until(`!!document.fullscreenElement === ${yes}`, 10);
    // The page's event comes with a frame of the browser's own.
    await browser.ask("new Promise((done) => setTimeout(done, 500)).then(() => step(5))");
  };
  await press("F11");
  await filled(true);
  await browser.ask("document.exitFullscreen()");
  await filled(false);
  await press("F11");
  await filled(true);
  await press("F11");
  await filled(false);
  console.log("F11 fills the screen and gives it back");

  // A page that is hidden pauses its flight: from then on no picture differs.
  await begin("#play=1");
  const moves = async () => { const before = await looks(); await step(20); return before !== await looks(); };
  await browser.key("keyDown", KEYS.ArrowRight);
  await step(2);
  check(await moves(), "the flight stands still");
  await browser.ask(`Object.defineProperty(document, "visibilityState", { get: () => "hidden", configurable: true });
    document.dispatchEvent(new Event("visibilitychange")); delete document.visibilityState`);
  await browser.key("keyUp", KEYS.ArrowRight);
  await step(60);
  check(!await moves(), "a hidden page flies on");
  await picture("hidden");

  // Keyboards of other layouts: + and − zoom as they are typed, the key at the place of W thrusts. Shift that types + starts nothing: all pictures
  // at the same moment, without particles, are the same.
  await keepSettings("particles,0,\n");
  const key = (code, text, modifiers = 0) => ({ key: text, code, number: 0, text, modifiers });
  const shift = { key: "Shift", code: "ShiftLeft", number: 16, modifiers: 8 };
  async function looksAfter(...chords) {
    await begin("#play=1");
    for (const chord of chords) {
      for (const one of chord) { await browser.key("keyDown", one); await step(2); }
      await step(10 - 2 * chord.length);
      for (const one of chord.toReversed()) await browser.key("keyUp", one);
      await step(2);
    }
    await step(30);
    return looks();
  }
  const zooms = [];
  for (const keys of [
    [[key("Equal", "=")], [key("Minus", "-")], [key("Equal", "=")]],
    [[shift, key("Equal", "+", 8)], [key("Minus", "-")], [shift, key("Equal", "+", 8)]],
    [[key("BracketRight", "+")], [key("Slash", "-")], [key("BracketRight", "+")]],
    [[shift, key("Equal", "+", 8)], [key("Digit6", "-")], [key("Equal", "=")]],
  ]) zooms.push(await looksAfter(...keys));
  await picture("zoomed");
  const still = await looksAfter([], [], []);
  check(zooms.every((zoomed) => zoomed === zooms[0]) && zooms[0] !== still, "+ and − are not those that are typed");
  const thrusts = [await looksAfter([key("KeyW", "w")]), await looksAfter([key("KeyW", "z")])];
  check(thrusts[0] === thrusts[1] && thrusts[0] !== await looksAfter([key("KeyZ", "w")]), "the place of W does not thrust");
  await browser.ask("localStorage.clear()");
  console.log("zoom and thrust on keyboards of us, de and fr");

  // Umlauts are set in the settings, and kept.
  await begin();
  await press(...SETTINGS, "Tab", "Enter");
  const tap = async (one) => { await browser.key("keyDown", one); await step(2); await browser.key("keyUp", one); await step(4); };
  await tap(key("Semicolon", "ö"));
  // All keys, then that of the map.
  await press(...Array(8).fill("ArrowDown"), "Enter", "ArrowDown", "ArrowDown", "ArrowDown", "Enter");
  await tap(key("Semicolon", "ö"));
  await picture("umlauts");
  const set = await kept("settings.csv");
  check(/^key_thrust,Semicolon W,$/m.test(set) && /^key_map,ö,$/m.test(set), `umlauts are not set: ${set}`);
  await browser.ask("localStorage.clear()");
  console.log("umlauts are set");

  // A link opens the level; the keys of a recorded flight fly it.
  await begin("#play=2");
  await picture("level-1");
  const record = readFileSync(join(root, "levels/2/flights/careful.replay.csv"), "utf8");
  const held = new Set();
  for (const row of record.split("\n").filter((row) => /^[0-9]+,/.test(row))) {
    const [ticks, ...keys] = row.split(",").map(Number);
    for (const [index, name] of STEER.entries()) {
      if ((keys[index] === 1) === held.has(name)) continue;
      await browser.key(held.has(name) ? "keyUp" : "keyDown", KEYS[name]);
      if (!held.delete(name)) held.add(name);
    }
    await step(Math.ceil(ticks / TICKS));
  }
  for (const name of held) await browser.key("keyUp", KEYS[name]);
  await step(60);
  await picture("scoring");
  const asks = () => browser.ask("{ const left = new Event('beforeunload', { cancelable: true }); window.dispatchEvent(left); left.defaultPrevented }");
  check(await asks(), "the page is left without a question although a score is not saved");
  const attempt = (await kept("scores/attempts.csv"))?.trim().split("\n").pop().trim();
  check(/^2,Guest,completed,/.test(attempt ?? ""), `level 2 is not completed: ${attempt}`);
  console.log("level 2 is flown by keys:", attempt);

  // Its score is saved, and is there when the page is loaded again.
  await press("ArrowDown", "ArrowDown", "ArrowDown", "Enter", ...USER, "Enter");
  await picture("saved");
  check(!await asks(), "the page asks although all is saved");
  const board = await kept("scores/2.csv");
  // After the first goal slow motion moves the later keys, so the score is not that of the record: the flight that is kept with it says it.
  const [, points, file] = new RegExp(`^${USER},([0-9]+),[0-9.]+,([^,\r\n]+)$`, "m").exec(board ?? "") ?? [];
  const flown = await browser.ask(`Object.entries(localStorage).find(([name]) => name.endsWith(${JSON.stringify(`/${file}`)}))?.[1]`);
  check(/^# outcome: completed$/m.test(flown ?? "") && flown.includes(`# score: ${points}\n`), `the flight of ${points} points is not saved: ${board}`);
  await begin();
  check(await kept("scores/2.csv") === board, "the score is another one after loading");
  await press("ArrowDown", "ArrowDown", "Enter", "ArrowRight", "Enter");
  await picture("leaderboard");
  console.log("its score is kept:", board.trim().split("\n").pop().trim());

  // A flight's code goes to the clipboard, and is flown again from there.
  await press("Enter");
  await browser.ask("navigator.clipboard.writeText = async (text) => { window.copied = text; }");
  await press("ArrowRight", "ArrowRight", "ArrowRight", "Enter");
  const code = await browser.ask("window.copied ?? ''");
  check(/^[\w.-]{50,1500}$/.test(code), `no code is copied: ${code}`);
  const flights = await looks();
  await browser.ask(`{ const data = new DataTransfer(); data.setData("text/plain", "${code}");
    window.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data })); }`);
  const control = { key: "Control", code: "ControlLeft", number: 17, modifiers: 2 };
  await browser.key("keyDown", control);
  await browser.key("keyDown", { ...letter("v"), text: undefined, modifiers: 2 });
  await step(2);
  await browser.key("keyUp", { ...letter("v"), modifiers: 2 });
  await browser.key("keyUp", { ...control, modifiers: 0 });
  await step(30);
  check(flights !== await looks(), "the pasted code changes nothing");
  await picture("pasted-code");
  console.log("a flight's code is copied and pasted:", code.length, "characters");

  // Everything goes out as one file, and comes back from it: Your data is the last button of the menu.
  await begin();
  await press("ArrowUp", "Enter");
  await browser.ask("URL.createObjectURL = (blob) => { window.given = blob; return ''; }");
  await picture("your-data");
  await press("Enter");
  check(await browser.ask("window.given.size") > 500, "nothing is exported");
  const drop = (bytes, name) => `ondrop({ preventDefault() {}, dataTransfer: { files: [new File([${bytes}], "${name}")] } })`;
  const archive = await browser.ask("given.arrayBuffer().then((bytes) => [...new Uint8Array(bytes)])");
  await browser.ask("localStorage.clear()");
  await begin();
  check(await kept("scores/2.csv") === null, "the storage is not empty");
  const again = browser.loaded();
  await browser.ask(`void ${drop(`new Uint8Array([${archive}])`, "resultant-data.zip")}.then(() => setTimeout(step, 0, 2))`);
  await again;
  await begin();
  await picture("imported");
  check(await kept("scores/2.csv") === board, "the score has not come back");
  console.log("everything is exported and imported:", archive.length, "bytes");

  // A level that is dropped as a zip is installed, and one that is none says why.
  const level = [...readFileSync(join(root, "target/web-level.zip"))];
  await browser.ask(`${drop(`new Uint8Array([${level}])`, "good_own_image.zip")}.then(() => step(30))`);
  check(await kept("levels/good_own_image/player.csv"), "the level is not installed");
  await picture("level-dropped");
  // Its pictures are in the browser's database when the page is loaded again.
  await begin("#play=good_own_image");
  await picture("own-picture");
  const pictures = await browser.ask(`new Promise((done, no) => {
    const opening = indexedDB.open("resultant");
    opening.onerror = no;
    opening.onsuccess = () => { opening.result.transaction("pictures").objectStore("pictures").getAllKeys().onsuccess = (keys) => done(keys.target.result); };
  })`);
  check(pictures.length === 3, `the database has ${pictures}`);
  await begin();
  await browser.ask(`${drop("'no archive'", "wrong.zip")}.then(() => step(30))`);
  await picture("wrong-zip");
  // One that is too large is refused before a byte of it is read.
  await browser.ask(`{ const large = new File(["large"], "large.zip");
    Object.defineProperty(large, "size", { value: 1.8e9 });
    large.arrayBuffer = () => { window.copied = true; };
    ondrop({ preventDefault() {}, dataTransfer: { files: [large] } }); }`);
  const refused = await browser.ask("document.getElementById('notice').textContent");
  check(/large.zip.*1800000000/.test(refused) && !await browser.ask("window.copied"), `a large file: ${refused}`);

  // A gamepad's first button presses.
  await begin();
  await browser.ask(`navigator.getGamepads = () => [{ mapping: "standard", axes: [0, 0, 0, 0],
    buttons: Array.from({ length: 17 }, (_, i) => ({ pressed: i === window.padded, value: Number(i === window.padded) })) }]`);
  const pad = async (button) => {
    await browser.ask(`window.padded = ${button}`);
    await step(2);
    await browser.ask("window.padded = null");
    await step(20);
  };
  const menu = await looks();
  await pad(0);
  await picture("gamepad");
  check(menu !== await looks(), "a gamepad's button presses nothing");

  // A damaged board is named, and stays as it is.
  const damaged = "tname,score\n\"Ann,12";
  await browser.ask(`localStorage.setItem("resultant/scores/2.csv", ${JSON.stringify(damaged)})`);
  await begin();
  await press("ArrowDown", "ArrowDown", "Enter", "ArrowDown", "Enter");
  await picture("damaged-board");
  check(await kept("scores/2.csv") === damaged, "the damaged board is another one");
  await browser.ask(`localStorage.setItem("resultant/scores/2.csv", ${JSON.stringify(board)})`);

  // A full storage: the flight's attempt cannot be written, and the board stays.
  await begin();
  await browser.ask("Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); }");
  await press(...SETTINGS, "ArrowRight");
  await picture("full-storage");
  check(await asks(), "the page is left without a question although nothing can be written");
  check(await kept("scores/2.csv") === board, "the board is another one");

  // A copy of a level that comes with the game, from its pause: Edit Level is the last button.
  await begin("#play=1");
  await press("Escape", ...Array(6).fill("ArrowDown"), "Enter");
  await picture("name-of-the-copy");
  await press("Enter");
  await step(30);
  await picture("copy");
  check(await kept("levels/1-copy/player.csv"), "no copy is made");
  console.log("a level is copied in the page");

  // A link to an experiment and one to a page of the lab; foreign and damaged ones say what is wrong.
  for (const [name, link] of [
    ["experiment", "#play=experiments/friction&follow=Box+1&details=1"], ["lab", "#lab=stress-tests"], ["foreign-link", "#play=../../etc"],
    ["damaged-link", "#play=1&follow=%zz"],
  ]) {
    await begin(link);
    await picture(name);
  }

  // Without a storage the page says so, and plays.
  const { identifier } = await browser.before("Object.defineProperty(window, 'localStorage', { get() { throw new DOMException('no', 'SecurityError'); } })");
  await begin("#play=1");
  check(/keeps no data/.test(await browser.ask("document.getElementById('notice').textContent")), "a forbidden storage is not named");
  await picture("forbidden-storage");
  await browser.send("Page.removeScriptToEvaluateOnNewDocument", { identifier });

  // Every recorded flight leads where it led.
  await browser.go("about:blank");
  await browser.go(`${server.address}#verify`);
  const lines = "document.getElementById('lines').textContent";
  await browser.until(`typeof wasm_exports === 'object' && (step(1), / of \\d+ flights hold/.test(${lines}))`, 180);
  const [, holds, all] = /(\d+) of (\d+) flights hold/.exec(await browser.ask(lines));
  console.log(`the page: ${holds} of ${all} flights hold`);
  check(all > 0 && holds === all, await browser.ask(lines));
} catch (error) {
  await browser.picture(join(out, "failed.png")).catch(() => {});
  console.error(error.stack, browser.console.filter((line) => !line.startsWith("Plugin")).join("\n"));
  process.exitCode = 1;
} finally {
  server.close();
  plain.close();
  await browser.close();
}
