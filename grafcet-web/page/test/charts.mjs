// Charts that the tests type.

export const MOTOR = `sfc Motor {
    input on, off, over_temp: bool;
    output relay, green, red: bool;

    initial step Off { N red; }
    step On { N relay; N green; }

    Off -[on && !over_temp]-> On -[off || over_temp]-> Off;
}
`;

// A ring of so many steps, each with an output and a way back.
export function ring(steps) {
  const all = Array.from({ length: steps }, (_, step) => step);
  return `sfc Ring {
    input go, stop: bool;
    output ${all.map(step => `y${step}`).join(", ")}: bool;
${all.map(step => `    ${step === 0 ? "initial " : ""}step S${step} { N y${step}; }`).join("\n")}
${all.map(step => `    S${step} -[rising(go) && !stop]-> S${(step + 1) % steps};`).join("\n")}
}
`;
}
