// The module of WebAssembly, in workers: what takes long must not hold the page, and can be ended.

let compiled = null;

function module() {
  compiled ??= fetch("grafcet_bg.wasm").then(async response => {
    if (!response.ok) throw new Error(`grafcet_bg.wasm: ${response.status} ${response.statusText}`);
    return WebAssembly.compile(await response.arrayBuffer());
  }).catch(error => {
    // The next one tries again.
    compiled = null;
    throw error;
  });
  return compiled;
}

// A question that will never be answered, as its engine was ended.
export class Ended extends Error {}

export class Engine {
  #worker = new Worker("worker.js", { type: "module" });
  #open = new Map();
  #next = 0;
  #started;
  isBroken = false;

  constructor() {
    this.#worker.addEventListener("message", ({ data: { id, answer, error, broken } }) => {
      const { resolve, reject } = this.#open.get(id);
      this.#open.delete(id);
      if (broken) this.isBroken = true;
      if (error === undefined) resolve(answer);
      else reject(new Error(error));
    });
    this.#worker.addEventListener("error", event => {
      this.isBroken = true;
      this.#fail(new Error(event.message || "the worker does not start"));
    });
    this.#started = module().then(module => this.#send("start", module));
    this.#started.catch(() => { this.isBroken = true; });
  }

  // Answers are JSON, or nothing.
  async ask(call, ...args) {
    await this.#started;
    const answer = await this.#send(call, ...args);
    return answer === undefined ? undefined : JSON.parse(answer);
  }

  end() {
    this.#worker.terminate();
    this.#fail(new Ended());
  }

  #send(call, ...args) {
    return new Promise((resolve, reject) => {
      const id = this.#next++;
      this.#open.set(id, { resolve, reject });
      this.#worker.postMessage({ id, call, args });
    });
  }

  #fail(error) {
    for (const { reject } of this.#open.values()) reject(error);
    this.#open.clear();
  }
}

// So long a text may keep the compiler from the one that has been typed since, in milliseconds.
const PATIENCE = 1500;

// One question about a text that changes: always the newest text is asked, those between are left out.
export class Latest {
  #engine = new Engine();
  #call;
  #show;
  #waiting = null;
  #busy = false;
  #since = 0;
  #timer = 0;

  // `show` gets a text and the answer, or an error.
  constructor(call, show) {
    this.#call = call;
    this.#show = show;
  }

  look(text) {
    this.#waiting = text;
    if (!this.#busy) void this.#work();
    else if (!this.#timer) this.#timer = setTimeout(() => this.#give(), Math.max(0, PATIENCE - (performance.now() - this.#since)));
  }

  #fresh() {
    if (this.#engine.isBroken) this.#anew();
    return this.#engine;
  }

  #anew() {
    this.#engine.end();
    this.#engine = new Engine();
  }

  #give() {
    this.#timer = 0;
    if (this.#waiting !== null) this.#anew();
  }

  async #work() {
    this.#busy = true;
    while (this.#waiting !== null) {
      const text = this.#waiting;
      this.#waiting = null;
      this.#since = performance.now();
      try {
        this.#show(text, await this.#fresh().ask(this.#call, text));
      } catch (error) {
        if (!(error instanceof Ended)) this.#show(text, null, error);
      }
      clearTimeout(this.#timer);
      this.#timer = 0;
    }
    this.#busy = false;
  }
}

// A question that was given up, as it took too long.
export class Late extends Error {}

// One question at a time, to an engine of its own: the next one ends what is still being asked, and so does time. Nobody else waits for it.
export class Single {
  #engine = null;
  #give = null;

  // `Ended` where another question has come meanwhile, `Late` after so many milliseconds.
  async ask(longest, call, ...args) {
    this.#give?.(new Ended());
    if (this.#engine?.isBroken) this.#stop();
    this.#engine ??= new Engine();
    let timer = 0;
    const given = new Promise((_, reject) => {
      const give = error => { this.#stop(); reject(error); };
      this.#give = give;
      timer = setTimeout(() => give(new Late()), longest);
    });
    const mine = this.#give;
    try {
      return await Promise.race([this.#engine.ask(call, ...args), given]);
    } finally {
      clearTimeout(timer);
      if (this.#give === mine) this.#give = null;
    }
  }

  #stop() {
    this.#give = null;
    this.#engine?.end();
    this.#engine = null;
  }
}
