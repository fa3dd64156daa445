// A chart that runs: what it has shown so far, and what is asked of it next. It knows no element of the page.

import { Engine, Ended } from "./engine.js";

// So many cycles a picture at most, so that the page stays quick where the chart cannot keep up with the time.
const MOST_CYCLES = 2000;
// How far "to the next change" looks.
const MOST_SKIPPED = 200_000;
// As many as the session itself can go back to.
const MOST_KEPT = 10_000;

export class Simulation {
  #engine = new Engine();
  #changed;
  #queue = Promise.resolve();
  #running = false;
  #rest = 0;
  #last = 0;
  names = null;
  // What was shown when something changed, and the present at the end.
  history = [];
  // Which of these is looked at.
  shown = 0;
  #values = [];
  #params = [];
  speed = 1;
  step = 1;
  trouble = null;

  // `changed` is called whenever there is something else to show.
  constructor(text, nanos, changed) {
    this.text = text;
    this.#changed = changed;
    this.ready = this.#do(async () => {
      const [names, now] = await this.#engine.ask("begin", text, 1);
      this.names = names;
      this.history = [now];
      this.#values = [...now.values];
      this.#params = [...now.params];
      await this.#period(nanos);
    });
  }

  // Where a moment begins on the axis of time: the beginning of all stands a cycle before the first one.
  begins({ number, elapsed }) { return number === 0 ? -this.step : elapsed; }

  get isRunning() { return this.#running; }
  get isLive() { return this.shown === this.history.length - 1; }
  get moment() { return this.history[this.shown]; }
  // What the next cycle is given.
  get values() { return this.isLive ? this.#values : this.moment.values; }
  get params() { return this.isLive ? this.#params : this.moment.params; }
  get latest() { return this.history[this.history.length - 1]; }

  // How long a cycle takes, in nanoseconds: at least a tick of the chart's clock.
  period(nanos) { return this.#do(() => this.#period(nanos)); }

  async #period(nanos) {
    this.step = Math.max(1, Math.round(nanos / this.names.nanosPerTick));
    await this.#engine.ask("step_by", this.step);
  }

  cycle(count = 1) { return this.#do(() => this.#cycle(count)); }

  skip() {
    return this.#do(async () => {
      await this.#here();
      this.#add(await this.#engine.ask("skip", MOST_SKIPPED));
    });
  }

  set(place, value) {
    return this.#do(async () => {
      await this.#here();
      await this.#engine.ask("set", place, String(value));
      this.#values[place] = value;
    });
  }

  setParam(place, value) {
    return this.#do(async () => {
      await this.#here();
      await this.#engine.ask("set_param", place, String(value));
      this.#params[place] = value;
    });
  }

  // The next cycle leads into the situation of these steps.
  force(steps) {
    return this.#do(async () => {
      await this.#here();
      this.#add(await this.#engine.ask("by_hand", Uint32Array.from(steps)));
    });
  }

  init() {
    return this.#do(async () => {
      await this.#here();
      await this.#engine.ask("init");
      await this.#cycle(1);
    });
  }

  run(running) {
    if (running === this.#running) return;
    this.#running = running;
    if (running) {
      this.#last = performance.now();
      this.#rest = 0;
      void this.#keepRunning();
    }
    this.#changed();
  }

  // Looks at a moment of the past; what is done next is done from there.
  look(at) {
    this.run(false);
    // After what was asked before: that is done now, and not in the past.
    return this.#do(async () => { this.shown = Math.max(0, Math.min(this.history.length - 1, at)); });
  }

  end() {
    this.#running = false;
    this.#engine.end();
  }

  async #keepRunning() {
    while (this.#running) {
      await new Promise(resolve => requestAnimationFrame(resolve));
      const now = performance.now();
      const nanos = (now - this.#last) * 1e6 * this.speed;
      this.#last = now;
      this.#rest = Math.min(this.#rest + nanos / (this.names.nanosPerTick * this.step), MOST_CYCLES);
      const cycles = Math.floor(this.#rest);
      this.#rest -= cycles;
      // Somebody may have stopped it, or look at the past, until what was asked before is done.
      if (cycles > 0) await this.#do(async () => { if (this.#running) await this.#cycle(cycles); });
    }
  }

  async #cycle(count) {
    await this.#here();
    for (const moment of await this.#engine.ask("advance", count)) this.#add(moment);
  }

  // Where the past is looked at, the session goes back there, and what came after is forgotten.
  async #here() {
    if (this.isLive) return;
    const { number } = this.moment;
    await this.#engine.ask("rewind", number);
    this.history.length = this.shown + 1;
    this.#values = [...this.moment.values];
    this.#params = [...this.moment.params];
  }

  #add(moment) {
    const before = this.latest;
    const follows = this.isLive;
    // What differs in nothing but the time takes the place of what does so, too.
    if (!moment.isNew && !before.isNew) this.history.pop();
    this.history.push(moment);
    if (this.history.length > MOST_KEPT) this.history.shift();
    if (follows) this.shown = this.history.length - 1;
    this.#params = [...moment.params];
  }

  // One after the other, in the order in which it was asked.
  #do(work) {
    const done = this.#queue.then(async () => {
      try {
        await work();
        this.trouble = null;
      } catch (error) {
        if (error instanceof Ended) return;
        this.#running = false;
        this.trouble = error.message;
      }
      this.#changed();
    });
    this.#queue = done;
    return done;
  }
}
