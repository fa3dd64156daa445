// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Crossing {
    situation: __CrossingState,
    reading: Ticks,
    since: Ticks,
    edge0_before: bool,
    before_state: __CrossingState,
}
impl Crossing {
    pub const fn new() -> Self {
        Self {
            situation: __CrossingState::INIT,
            reading: Ticks::ZERO,
            since: Ticks::ZERO,
            edge0_before: false,
            before_state: __CrossingState::Cars,
        }
    }
}
impl Crossing {
    pub fn cycle(
        &mut self,
        inputs: &CrossingInputs,
        now: impl core::convert::Into<Ticks>,
    ) -> CrossingOutputs {
        let now: Ticks = core::convert::Into::into(
            now,
        );
        let mut outputs = const {
            CrossingOutputs {
                green: false,
                yellow: false,
                red: false,
                wait: false,
                walk: false,
                chirp: false,
                hurry: false,
            }
        };
        self.before_state = self.situation;
        self.reading = now;
        let passed: Ticks = now.since(self.since);
        let mut goes: bool = false;
        match self.situation {
            __CrossingState::INIT => {
                goes = true;
            }
            __CrossingState::Cars => {
                goes = !self.edge0_before && inputs.button;
            }
            __CrossingState::Stop => {
                if passed >= Ticks::new(2000u32) {
                    outputs.chirp = true;
                    goes = true;
                }
            }
            __CrossingState::Walk => {
                if passed >= Ticks::new(8000u32) {
                    goes = true;
                } else {
                    outputs.chirp = passed < Ticks::new(1000u32);
                    outputs.hurry = passed >= Ticks::new(6000u32);
                }
            }
            __CrossingState::Asked
            | __CrossingState::Yellow
            | __CrossingState::Clear => {
                goes = passed
                    >= (Ticks::new({
                        const TABLE: [u16; 7usize] = [
                            0, 5000, 3000, 0, 0, 4000, 0,
                        ];
                        match TABLE.get(self.situation as usize) {
                            Option::Some(found) => {
                                u32::from(*found)
                            }
                            Option::None => 0,
                        }
                    }));
            }
        }
        if goes {
            self.situation = {
                const TABLE: [__CrossingState; 7usize] = [
                    __CrossingState::Asked,
                    __CrossingState::Yellow,
                    __CrossingState::Stop,
                    __CrossingState::Walk,
                    __CrossingState::Clear,
                    __CrossingState::Cars,
                    __CrossingState::Cars,
                ];
                match TABLE.get(self.situation as usize) {
                    Option::Some(found) => *found,
                    Option::None => self.situation,
                }
            };
            self.since = now;
        }
        match self.situation {
            __CrossingState::Cars => {
                outputs.green = true;
            }
            __CrossingState::Asked => {
                outputs.green = true;
                outputs.wait = true;
            }
            __CrossingState::Yellow => {
                outputs.wait = true;
                outputs.yellow = true;
            }
            __CrossingState::Stop => {
                outputs.wait = true;
                outputs.red = true;
            }
            __CrossingState::Walk => {
                outputs.red = true;
                outputs.walk = true;
            }
            __CrossingState::Clear => {
                outputs.red = true;
            }
            __CrossingState::INIT => {}
        }
        self.edge0_before = inputs.button;
        outputs
    }
    pub fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if self.before_state != self.situation {
            return Option::Some(self.since);
        }
        let mut soonest = Option::None;
        if self.situation == __CrossingState::Asked
            && self.reading.since(self.since) < Ticks::new(5000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(5000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Yellow
            && self.reading.since(self.since) < Ticks::new(3000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(3000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Stop
            && self.reading.since(self.since) < Ticks::new(2000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(2000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(1000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(1000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(6000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(6000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(8000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(8000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Clear
            && self.reading.since(self.since) < Ticks::new(4000u32)
        {
            soonest = sooner(
                soonest,
                Option::Some(
                    Ticks::new(4000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        match soonest {
            Option::Some(time) => {
                Option::Some(self.reading.after(time))
            }
            Option::None => Option::None,
        }
    }
}
