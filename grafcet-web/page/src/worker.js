// The compiler, or one session of a chart that runs: calls in, answers out, one after the other.
import { Session, check, initSync, look, translate } from "grafcet";

let session = null;

const calls = {
  start: module => { initSync({ module }); },
  look,
  check,
  translate,
  begin: (text, step) => {
    session = new Session(text, step);
    return JSON.stringify([JSON.parse(session.names()), JSON.parse(session.now())]);
  },
};

addEventListener("message", ({ data: { id, call, args } }) => {
  try {
    const answer = call in calls ? calls[call](...args) : session[call](...args);
    postMessage({ id, answer });
  } catch (error) {
    // What Rust refuses is a text; anything else is a fault of the program, after which the module is of no use.
    postMessage({ id, error: String(error), broken: typeof error !== "string" });
  }
});
