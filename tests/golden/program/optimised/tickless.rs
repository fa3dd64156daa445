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
            edge0_before: true,
            before_state: __CrossingState::Cars,
        }
    }
}
impl Crossing {
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &CrossingInputs,
        #[cfg(doc)]
        inputs: &CrossingInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> CrossingOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
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
        self.reading = now_;
        let passed_: Ticks = now_.since(self.since);
        let mut goes_: bool = false;
        match self.situation {
            __CrossingState::INIT => {
                goes_ = true;
            }
            __CrossingState::Cars => {
                goes_ = !self.edge0_before && inputs_.button;
            }
            __CrossingState::Stop => {
                if has_reached!(
                    passed_, Ticks::new(2000u32)
                ) {
                    outputs_.chirp = true;
                    goes_ = true;
                }
            }
            __CrossingState::Walk => {
                if has_reached!(
                    passed_, Ticks::new(8000u32)
                ) {
                    goes_ = true;
                } else {
                    outputs_.chirp = passed_ < Ticks::new(1000u32);
                    outputs_.hurry = passed_
                        >= Ticks::new(6000u32);
                }
            }
            __CrossingState::Asked
            | __CrossingState::Yellow
            | __CrossingState::Clear => {
                goes_ = passed_
                    >= (Ticks::new({
                        const TABLE: [u16; 7usize] = [
                            0, 5000, 3000, 0, 0, 4000, 0,
                        ];
                        match <[_]>::get(
                            &TABLE,
                            self.situation as usize,
                        ) {
                            Option::Some(found_) => {
                                u32::from(*found_)
                            }
                            Option::None => 0,
                        }
                    }));
            }
        }
        if goes_ {
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
                match <[_]>::get(&TABLE, self.situation as usize) {
                    Option::Some(found_) => *found_,
                    Option::None => self.situation,
                }
            };
            self.since = now_;
        }
        match self.situation {
            __CrossingState::Cars => {
                outputs_.green = true;
            }
            __CrossingState::Asked => {
                outputs_.green = true;
                outputs_.wait = true;
            }
            __CrossingState::Yellow => {
                outputs_.wait = true;
                outputs_.yellow = true;
            }
            __CrossingState::Stop => {
                outputs_.wait = true;
                outputs_.red = true;
            }
            __CrossingState::Walk => {
                outputs_.red = true;
                outputs_.walk = true;
            }
            __CrossingState::Clear => {
                outputs_.red = true;
            }
            __CrossingState::INIT => {}
        }
        self.edge0_before = inputs_.button;
        outputs_
    }
    pub fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if self.before_state != self.situation {
            return Option::Some(self.since);
        }
        let mut soonest_ = Option::None;
        if self.situation == __CrossingState::Asked
            && self.reading.since(self.since) < Ticks::new(5000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(5000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Yellow
            && self.reading.since(self.since) < Ticks::new(3000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(3000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Stop
            && self.reading.since(self.since) < Ticks::new(2000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(2000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(1000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(1000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(6000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(6000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Walk
            && self.reading.since(self.since) < Ticks::new(8000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(8000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        if self.situation == __CrossingState::Clear
            && self.reading.since(self.since) < Ticks::new(4000u32)
        {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(4000u32)
                        - self.reading.since(self.since),
                ),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.reading.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
