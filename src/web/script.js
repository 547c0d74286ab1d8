// The page's half of src/web: storage, sound, gamepads, clipboard, links and files. miniquad's loader stands before it in one file.
"use strict";
(function () {
  const PREFIX = "resultant/";
  // Before each text that this program keeps.
  const MARK = "t";
  const FULL = -2, FORBIDDEN = -3, DAMAGED = -4;
  const at = (id) => document.getElementById(id);
  const bytesAt = (from, length) => new Uint8Array(wasm_memory.buffer, from, length);
  const textAt = (from, length) => new TextDecoder().decode(bytesAt(from, length));
  let answer = new Uint8Array();
  const answers = (bytes) => { answer = bytes; return bytes.length; };
  const encoded = (text) => new TextEncoder().encode(text);
  /** Hands bytes over to the program; returns where they are and how many. */
  const handed = (bytes) => { const to = wasm_exports.resultant_room(bytes.length); bytesAt(to, bytes.length).set(bytes); return [to, bytes.length]; };

  function tell(words) { at("notice").textContent = words + "  ×"; at("notice").hidden = false; }
  function stop(words) {
    at("words").hidden = false;
    at("words").className = "stopped";
    at("words").textContent = words;
  }
  at("notice").onclick = () => { at("notice").hidden = true; canvas.focus(); };

  // Storage of text. Without one a page keeps all until it is closed.
  let storage;
  try {
    storage = window.localStorage;
    storage.setItem(PREFIX + "?", "");
    storage.removeItem(PREFIX + "?");
  } catch (error) {
    if (!storage || error.name !== "QuotaExceededError") {
      const held = new Map();
      storage = {
        getItem: (key) => held.get(key) ?? null, setItem: (key, value) => held.set(key, value), removeItem: (key) => held.delete(key),
        key: (index) => [...held.keys()][index], get length() { return held.size; },
      };
      tell("This browser keeps no data for this page: scores and levels last until it is closed. “Your data” in the menu exports them.");
    }
  }
  function decoded(bytes) {
    try { return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes); } catch { return null; }
  }

  // Bytes that are no text, such as the pictures of own levels, go to the browser's database, which has more room. They are loaded before
  // the program begins, and written behind it.
  const PICTURES = "pictures";
  const pictures = new Map();
  const tabs = window.BroadcastChannel && new BroadcastChannel("resultant");
  let database, writing = Promise.resolve();
  if (tabs) tabs.onmessage = ({ data: [key, bytes] }) => { bytes ? pictures.set(key, bytes) : pictures.delete(key); };
  const answered = (request) => new Promise((yes, no) => {
    request.onsuccess = () => yes(request.result);
    request.onerror = () => no(request.error);
  });
  async function loadPictures() {
    const opening = window.indexedDB.open("resultant", 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore(PICTURES);
    const opened = await answered(opening);
    const store = opened.transaction(PICTURES).objectStore(PICTURES);
    const [keys, values] = await Promise.all([answered(store.getAllKeys()), answered(store.getAll())]);
    keys.forEach((key, i) => { if (values[i] instanceof Uint8Array) pictures.set(key, values[i]); });
    database = opened;
  }
  /** Keeps bytes under a key; without bytes, removes them. */
  function keepPicture(key, bytes) {
    if (bytes) pictures.set(key, bytes);
    else if (!pictures.delete(key)) return;
    tabs?.postMessage([key, bytes]);
    writing = writing.then(() => new Promise((yes, no) => {
      if (!database) throw new Error("the browser has no database for this page");
      const change = database.transaction(PICTURES, "readwrite");
      if (bytes) change.objectStore(PICTURES).put(bytes, key);
      else change.objectStore(PICTURES).delete(key);
      change.oncomplete = yes;
      change.onabort = () => no(change.error ?? new Error("the browser has stopped the write"));
    })).catch((error) => {
      tell(`${key} is not written: ${error.message || error.name}. It lasts until the page is closed. “Your data” in the menu exports it.`);
    });
  }

  // Sound: a worklet, or a script processor where the page is not secure, asks for blocks of 1024 frames; two are always on the way.
  const FRAMES = 1024, AHEAD = 3;
  const WORKLET = `registerProcessor("resultant", class extends AudioWorkletProcessor {
    constructor() { super(); this.blocks = []; this.at = 0; this.port.onmessage = (event) => this.blocks.push(event.data); }
    process(_, [[left, right]]) {
      for (let i = 0; i < left.length; i++) {
        const block = this.blocks[0];
        if (!block) break;
        left[i] = block[this.at++]; (right ?? left)[i] = block[this.at++];
        if (this.at >= block.length) { this.blocks.shift(); this.at = 0; this.port.postMessage(0); }
      }
      return true;
    }
  });`;
  let sound;
  function block() {
    const from = wasm_exports.resultant_sound_block(FRAMES);
    return from ? new Float32Array(wasm_memory.buffer, from, 2 * FRAMES).slice() : new Float32Array(2 * FRAMES);
  }
  async function beginSound() {
    if (sound) { if (sound.state === "suspended" && graphics) sound.resume(); return; }
    if (!wasm_exports || !window.AudioContext) return;
    sound = new AudioContext({ latencyHint: "interactive" });
    wasm_exports.resultant_sound_begins(sound.sampleRate);
    try {
      if (sound.audioWorklet) {
        await sound.audioWorklet.addModule(URL.createObjectURL(new Blob([WORKLET], { type: "text/javascript" })));
        const node = new AudioWorkletNode(sound, "resultant", { numberOfInputs: 0, outputChannelCount: [2] });
        node.port.onmessage = () => node.port.postMessage(block());
        for (let i = 0; i < AHEAD; i++) node.port.postMessage(block());
        node.connect(sound.destination);
      } else {
        const node = sound.createScriptProcessor(FRAMES, 0, 2);
        node.onaudioprocess = ({ outputBuffer }) => {
          const samples = block();
          const [left, right] = [outputBuffer.getChannelData(0), outputBuffer.getChannelData(1)];
          for (let i = 0; i < FRAMES; i++) { left[i] = samples[2 * i]; right[i] = samples[2 * i + 1]; }
        };
        node.connect(sound.destination);
        window.resultantNode = node;
      }
    } catch (error) { console.warn("no sound:", error); }
  }
  for (const press of ["keydown", "pointerdown"]) window.addEventListener(press, beginSound, true);

  // Files that are dropped, chosen or pasted as files.
  async function hand(files) {
    for (const file of files) {
      const name = encoded(file.name);
      if (wasm_exports.resultant_refuses(...handed(name), file.size)) continue;
      const bytes = new Uint8Array(await file.arrayBuffer());
      wasm_exports.resultant_dropped(...handed(name), ...handed(bytes));
    }
  }

  // A screen where nothing is flown names the time until its next frame, s; a press, the wheel or a file does not wait for it.
  const OPENED = Date.now() - performance.now();
  let begun = 0, next = 0, graphics = true;
  const frame = animation;
  animation = (now) => {
    if (!graphics) return;
    // Also where the clock was set back.
    if (begun <= now && now < next) animation_frame_timeout = window.requestAnimationFrame(animation);
    else { begun = now; frame(); }
  };
  for (const news of ["keydown", "keyup", "pointerdown", "pointerup", "wheel", "paste", "drop"]) window.addEventListener(news, () => { next = 0; }, true);

  // Keys go by their places and by what they type; the loader knows places of the US layout alone. What a browser does with a key of its own is
  // prevented where the game has the key: scrolling, going back, searching.
  const OWN = /^(Space|Tab|Backspace|Arrow(Up|Down|Left|Right)|F([1-9]|1[01]))$/, SEARCH = ["'", "/"];
  function takeKeys() {
    const told = (call, code, ...rest) => wasm_exports[call](...handed(encoded(code)), ...rest);
    const sign = (key) => [...key].length === 1 ? key.codePointAt(0) : 0;
    canvas.onkeydown = (event) => {
      const { code, key, shiftKey, ctrlKey, metaKey, altKey, repeat } = event;
      const third = altKey || event.getModifierState("AltGraph"), lock = event.getModifierState("CapsLock");
      const prevents = OWN.test(code) || SEARCH.includes(key);
      if (prevents || ctrlKey && code === "KeyS") event.preventDefault();
      told("resultant_key_down", code, sign(key), shiftKey | (ctrlKey || metaKey) << 1 | third << 2 | repeat << 3 | lock << 4);
      if (prevents && sign(key)) wasm_exports.resultant_key_types(sign(key));
    };
    canvas.onkeyup = ({ code }) => told("resultant_key_up", code);
    canvas.onkeypress = ({ charCode, ctrlKey, metaKey, altKey }) => {
      if (!(ctrlKey && !altKey || metaKey)) wasm_exports.resultant_key_types(charCode);
    };
    canvas.onblur = () => wasm_exports.resultant_keys_leave();
    navigator.keyboard?.getLayoutMap?.().then((map) => map.forEach((key, code) => told("resultant_key_sign", code, sign(key)))).catch(() => {});
  }
  // A browser may take the graphics away, with all textures and shaders, for which macroquad has no way to make them again.
  canvas.addEventListener("webglcontextlost", () => {
    graphics = false;
    sound?.suspend();
    wasm_exports.resultant_graphics_lost();
    at("words").onclick = () => location.reload();
  });

  const fit = () => resize(canvas, wasm_exports.resize);
  let ratio = devicePixelRatio;
  let link = location.hash.slice(1), lastLink = "";
  window.addEventListener("hashchange", () => { link = location.hash.slice(1); });

  miniquad_add_plugin({
    name: "resultant",
    version: 4,
    register_plugin: (imports) => {
      const loop = imports.env.run_animation_loop, setClipboard = imports.env.sapp_set_clipboard;
      const fullscreen = imports.env.sapp_set_fullscreen;
      Object.assign(imports.env, {
        resultant_now: () => performance.now(),
        // macroquad makes up for all time that passes here, 60 steps a second: a date that jumps by years would take it seconds.
        now: () => (OPENED + performance.now()) / 1000,
        resultant_take: (to) => bytesAt(to, answer.length).set(answer),
        resultant_get: (key, length) => {
          const name = textAt(key, length);
          if (pictures.has(name)) return answers(pictures.get(name));
          let value;
          try { value = storage.getItem(PREFIX + name); } catch { return FORBIDDEN; }
          if (value === null) return -1;
          return value[0] === MARK ? answers(encoded(value.slice(1))) : DAMAGED;
        },
        resultant_keys: () => {
          const keys = [...pictures.keys()];
          for (let i = 0; i < storage.length; i++) {
            const key = storage.key(i);
            if (key.startsWith(PREFIX)) keys.push(key.slice(PREFIX.length));
          }
          return answers(encoded(keys.join("\0")));
        },
        resultant_set: (key, length, value, valueLength) => {
          const [name, bytes] = [textAt(key, length), bytesAt(value, valueLength)];
          const text = decoded(bytes);
          try {
            if (text === null) storage.removeItem(PREFIX + name);
            else storage.setItem(PREFIX + name, MARK + text);
          } catch (error) {
            return error.name === "QuotaExceededError" || error.name === "NS_ERROR_DOM_QUOTA_REACHED" ? FULL : FORBIDDEN;
          }
          keepPicture(name, text === null ? bytes.slice() : undefined);
          return 0;
        },
        resultant_remove: (key, length) => {
          const name = textAt(key, length);
          keepPicture(name);
          try { storage.removeItem(PREFIX + name); } catch { /* It stays. */ }
        },
        resultant_pads: (to) => {
          const levels = new Float32Array(wasm_memory.buffer, to, 19);
          levels.fill(0);
          let pads = [];
          try { pads = navigator.getGamepads?.() ?? []; } catch { /* The page may not ask. */ }
          for (const pad of pads) {
            if (pad?.mapping !== "standard") continue;
            pad.buttons.slice(0, 17).forEach((button, i) => { levels[i] = Math.max(levels[i], button.pressed ? 1 : button.value); });
            for (const axis of [0, 1]) if (Math.abs(pad.axes[axis]) > Math.abs(levels[17 + axis])) levels[17 + axis] = pad.axes[axis];
          }
        },
        resultant_link: () => { const news = link; if (news) lastLink = news; link = ""; return answers(encoded(news)); },
        resultant_link_again: () => { link = lastLink; },
        resultant_language: () => answers(encoded(navigator.language ?? "")),
        resultant_say: (kind, from, length) => {
          const words = textAt(from, length);
          if (kind === 0) stop(words || "The game has ended. Load the page again to play on.");
          else if (kind === 1) { at("words").hidden = true; at("lines").hidden = false; at("lines").textContent += words + "\n"; }
          else if (kind === 2) tell(words);
          else {
            try { sessionStorage.setItem(PREFIX + "notice", words); } catch { /* No word then. */ }
            writing.then(() => location.reload());
          }
        },
        resultant_frame_ends: (rest) => {
          // In a frame the program takes no other call.
          if (ratio !== devicePixelRatio) { ratio = devicePixelRatio; setTimeout(fit); }
          if (!window.resultantReady) { window.resultantReady = performance.now(); at("words").hidden = true; }
          window.resultantFrames = (window.resultantFrames ?? 0) + 1;
          // Frames come some milliseconds early and late.
          next = rest > 0 ? begun + 1000 * rest - 5 : 0;
        },
        resultant_download: (name, nameLength, bytes, length) => {
          const anchor = document.createElement("a");
          anchor.href = URL.createObjectURL(new Blob([bytesAt(bytes, length).slice()], { type: "application/octet-stream" }));
          anchor.download = textAt(name, nameLength);
          anchor.click();
          setTimeout(() => URL.revokeObjectURL(anchor.href), 60000);
        },
        resultant_choose_file: () => {
          const field = document.createElement("input");
          field.type = "file";
          field.accept = ".zip";
          field.onchange = () => { hand(field.files); canvas.focus(); };
          field.click();
        },
        // The loader fills the clipboard at the next press of Ctrl+C; this one at once.
        sapp_set_clipboard: (from, length) => {
          setClipboard(from, length);
          navigator.clipboard?.writeText(textAt(from, length)).catch(() => {});
        },
        sapp_set_fullscreen: (wanted) => {
          const refused = () => wasm_exports.resultant_fullscreen(0);
          if (wanted) canvas.requestFullscreen ? canvas.requestFullscreen().catch(refused) : setTimeout(refused);
          else if (document.fullscreenElement) fullscreen(false);
        },
        run_animation_loop: (blocking) => {
          loop(blocking);
          window.ondrop = (event) => { event.preventDefault(); return hand(event.dataTransfer.files); };
          window.addEventListener("paste", (event) => hand(event.clipboardData?.files ?? []), true);
          document.addEventListener("fullscreenchange", () => wasm_exports.resultant_fullscreen(document.fullscreenElement ? 1 : 0));
          canvas.oncontextmenu = (event) => event.preventDefault();
          takeKeys();
          // The browser may change the canvas' size without a window's event: its zoom, another screen, fullscreen.
          new ResizeObserver(fit).observe(canvas);
          window.addEventListener("beforeunload", (event) => {
            if (wasm_exports.resultant_at_risk()) event.preventDefault();
          });
          document.addEventListener("visibilitychange", () => {
            if (document.visibilityState === "visible") return void sound?.resume();
            wasm_exports.resultant_hidden();
            sound?.suspend();
          });
          canvas.focus();
        },
      });
    },
  });

  // Only a program that is served as one is compiled while it comes; not every server knows its kind.
  const streaming = WebAssembly.compileStreaming?.bind(WebAssembly);
  if (streaming) WebAssembly.compileStreaming = async (coming) => {
    const came = await coming;
    if (!came.ok) throw new Error(`${came.url}: ${came.status} ${came.statusText}`);
    return came.headers.get("content-type") === "application/wasm" ? streaming(came) : WebAssembly.compile(await came.arrayBuffer());
  };

  const failed = (event) => {
    const reason = String(event.message ?? event.reason ?? "");
    if (window.resultantReady && !/unreachable|RuntimeError|out of bounds/.test(reason)) return;
    stop("The game has stopped.\nWhat was saved is kept. Load the page again to play on.\n\n" + reason);
  };
  window.addEventListener("error", failed);
  window.addEventListener("unhandledrejection", failed);
  // The loader reports what keeps the program from starting to the console alone.
  const report = console.error;
  console.error = (...words) => { report(...words); if (!window.resultantReady) failed({ message: words.join(" ") }); };

  let notice = null;
  try { notice = sessionStorage.getItem(PREFIX + "notice"); sessionStorage.removeItem(PREFIX + "notice"); } catch { /* None. */ }
  if (notice) tell(notice);
  if (location.protocol === "file:") stop("Resultant is opened from a web server: a browser does not let a page read the program beside it from a disk.\nSuch a server is  python3 -m http.server  in this folder.");
  else if (typeof WebAssembly !== "object") stop("This browser has no WebAssembly, which Resultant needs.");
  else if (!document.createElement("canvas").getContext("webgl")) stop("This browser has no WebGL, which Resultant draws with: it may be switched off in the settings.");
  else {
    const late = new Promise((_, no) => setTimeout(no, 10000, new Error("the browser's database does not answer")));
    Promise.race([loadPictures(), late])
      .catch((error) => { if (at("notice").hidden) tell(`Pictures of own levels cannot be read: ${error.message || error.name}`); })
      .then(() => load("resultant.wasm"));
  }
})();
