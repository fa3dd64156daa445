// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __WateringState {
    Rest,
    Lawn,
    Hedge,
    Beds,
    Soak,
    INIT,
}
impl Watering {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &WateringInputs,
        #[cfg(doc)]
        inputs: &WateringInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> WateringOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = WateringOutputs {
            lawn: false,
            hedge: false,
            beds: false,
            days: 0,
        };
        self.before_state = self.situation;
        let mut goes_: bool = false;
        match self.situation {
            __WateringState::INIT => {
                goes_ = true;
            }
            __WateringState::Rest => {
                if inputs_.dry {
                    self.days = {
                        #[allow(unused_variables)]
                        let days = self.days;
                        days.wrapping_add(1)
                    };
                    goes_ = true;
                }
            }
            __WateringState::Lawn
            | __WateringState::Hedge
            | __WateringState::Beds
            | __WateringState::Soak => {
                goes_ = now_.since(self.since)
                    >= (Ticks::new({
                        const TABLE: [u32; 6usize] = [
                            0, 1200000, 600000, 900000, 86400000, 0,
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
                const TABLE: [__WateringState; 6usize] = [
                    __WateringState::Lawn,
                    __WateringState::Hedge,
                    __WateringState::Beds,
                    __WateringState::Soak,
                    __WateringState::Rest,
                    __WateringState::Rest,
                ];
                match <[_]>::get(&TABLE, self.situation as usize) {
                    Option::Some(found_) => *found_,
                    Option::None => self.situation,
                }
            };
            self.since = now_;
        }
        match self.situation {
            __WateringState::Lawn => {
                outputs_.lawn = true;
            }
            __WateringState::Hedge => {
                outputs_.hedge = true;
            }
            __WateringState::Beds => {
                outputs_.beds = true;
            }
            __WateringState::Rest | __WateringState::Soak | __WateringState::INIT => {}
        }
        outputs_.days = self.days;
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
        if self.situation == __WateringState::Lawn {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(1200000u32),
                ),
            );
        }
        if self.situation == __WateringState::Hedge {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(600000u32),
                ),
            );
        }
        if self.situation == __WateringState::Beds {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(900000u32),
                ),
            );
        }
        if self.situation == __WateringState::Soak {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(86400000u32),
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
