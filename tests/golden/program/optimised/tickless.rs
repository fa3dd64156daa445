// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

pub struct Crossing {
    state: __CrossingState,
    reading: Ticks,
    since: Ticks,
    edge0_before: bool,
    before_state: __CrossingState,
}
impl Crossing {
    pub const fn new() -> Self {
        Self {
            state: __CrossingState::INIT,
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
        let was_state: __CrossingState = self.state;
        self.before_state = self.state;
        self.reading = now;
        match self.state {
            __CrossingState::INIT => {
                self.state = __CrossingState::Cars;
            }
            __CrossingState::Cars => {
                if !self.edge0_before && inputs.button {
                    self.state = __CrossingState::Asked;
                }
            }
            __CrossingState::Asked => {
                if now.since(self.since) >= Ticks::new(5000u32) {
                    self.state = __CrossingState::Yellow;
                }
            }
            __CrossingState::Yellow => {
                if now.since(self.since) >= Ticks::new(3000u32) {
                    self.state = __CrossingState::Stop;
                }
            }
            __CrossingState::Stop => {
                if now.since(self.since) >= Ticks::new(2000u32) {
                    self.state = __CrossingState::Walk;
                    outputs.chirp = true;
                }
            }
            __CrossingState::Walk => {
                if now.since(self.since) >= Ticks::new(8000u32) {
                    self.state = __CrossingState::Clear;
                } else {
                    outputs.chirp = now.since(self.since)
                        < Ticks::new(1000u32);
                    outputs.hurry = now.since(self.since)
                        >= Ticks::new(6000u32);
                }
            }
            __CrossingState::Clear => {
                if now.since(self.since) >= Ticks::new(4000u32) {
                    self.state = __CrossingState::Cars;
                }
            }
            _ => {}
        }
        if was_state != self.state {
            self.since = now;
        }
        match self.state {
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
            _ => {}
        }
        self.edge0_before = inputs.button;
        outputs
    }
    pub fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if self.before_state != self.state {
            return Option::Some(self.since);
        }
        let mut soonest = Option::None;
        if self.state == __CrossingState::Asked
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
        if self.state == __CrossingState::Yellow
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
        if self.state == __CrossingState::Stop
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
        if self.state == __CrossingState::Walk
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
        if self.state == __CrossingState::Walk
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
        if self.state == __CrossingState::Walk
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
        if self.state == __CrossingState::Clear
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
