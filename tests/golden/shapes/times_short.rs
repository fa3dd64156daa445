// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __WasherState {
    Idle,
    Fill,
    Wash,
    Drain,
    Spin,
    INIT,
}
impl Washer {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &WasherInputs,
        #[cfg(doc)]
        inputs: &WasherInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> WasherOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = WasherOutputs {
            water: false,
            drum: false,
            pump: false,
            washes: 0,
        };
        self.before_state = self.situation;
        let mut goes_: bool = false;
        match self.situation {
            __WasherState::INIT => {
                goes_ = true;
            }
            __WasherState::Idle => {
                if inputs_.start {
                    self.washes = {
                        #[allow(unused_variables)]
                        let washes = self.washes;
                        washes.wrapping_add(1)
                    };
                    goes_ = true;
                }
            }
            __WasherState::Fill
            | __WasherState::Wash
            | __WasherState::Drain
            | __WasherState::Spin => {
                goes_ = now_.since(self.since)
                    >= (Ticks::new({
                        const TABLE: [u16; 6usize] = [
                            0, 20000, 45000, 15000, 60000, 0,
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
                const TABLE: [__WasherState; 6usize] = [
                    __WasherState::Fill,
                    __WasherState::Wash,
                    __WasherState::Drain,
                    __WasherState::Spin,
                    __WasherState::Idle,
                    __WasherState::Idle,
                ];
                match <[_]>::get(&TABLE, self.situation as usize) {
                    Option::Some(found_) => *found_,
                    Option::None => self.situation,
                }
            };
            self.since = now_;
        }
        match self.situation {
            __WasherState::Fill => {
                outputs_.water = true;
            }
            __WasherState::Wash | __WasherState::Spin => {
                outputs_.drum = true;
            }
            __WasherState::Drain => {
                outputs_.pump = true;
            }
            __WasherState::Idle | __WasherState::INIT => {}
        }
        outputs_.washes = self.washes;
        outputs_
    }
    /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
    /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
    /// "scan again at once"; `None` means "only an input can change anything".
    #[must_use]
    fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if self.before_state != self.situation {
            return Option::Some(self.since);
        }
        let mut soonest_ = Option::None;
        if self.situation == __WasherState::Fill {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(20000u32),
                ),
            );
        }
        if self.situation == __WasherState::Wash {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(45000u32),
                ),
            );
        }
        if self.situation == __WasherState::Drain {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(15000u32),
                ),
            );
        }
        if self.situation == __WasherState::Spin {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(60000u32),
                ),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.since.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
