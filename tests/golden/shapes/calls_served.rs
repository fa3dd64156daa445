// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __CallsServedRegion0 {
    Listen,
    INIT,
}
enum __CallsServedRegion1 {
    Rest,
    Run,
    Serve,
    Close,
}
impl CallsServed {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &CallsServedInputs,
        #[cfg(doc)]
        inputs: &CallsServedInputs,
        #[cfg(not(doc))]
        now_: impl core::convert::Into<
            Ticks,
        >,
        #[cfg(doc)]
        now: impl core::convert::Into<Ticks>,
    ) -> CallsServedOutputs {
        let now_: Ticks = core::convert::Into::into(
            now_,
        );
        let mut outputs_ = const {
            CallsServedOutputs {
                lamp: false,
                drive: false,
                open: false,
            }
        };
        let first_: bool = self.region_0
            == __CallsServedRegion0::INIT;
        if first_ {
            self.region_0 = __CallsServedRegion0::Listen;
        }
        let inputs_ = core::hint::black_box(inputs_);
        let mut edge1_now_: bool = false;
        let mut next_served_: core::primitive::u8 = 0;
        loop {
            fence_on_armv6m();
            let mut moves_27__: bool = false;
            let was_state_rest_: __CallsServedRegion1 = self.region_1;
            let mut next_lamp_: bool = self.lamp;
            edge1_now_ = was_state_rest_ == __CallsServedRegion1::Serve;
            let passed_: Ticks = now_.since(self.since_rest);
            match self.region_1 {
                __CallsServedRegion1::Rest => {
                    if self.lamp {
                        self.region_1 = __CallsServedRegion1::Run;
                        moves_27__ = true;
                    }
                }
                __CallsServedRegion1::Run => {
                    if inputs_.there {
                        self.region_1 = __CallsServedRegion1::Serve;
                        next_served_ = {
                            let served = self.served;
                            served + 1
                        };
                        moves_27__ = true;
                        self.served = next_served_;
                        self.since_rest = now_;
                    }
                }
                __CallsServedRegion1::Serve => {
                    if has_reached!(
                        passed_, Ticks::new(500u32)
                    ) {
                        self.region_1 = __CallsServedRegion1::Close;
                        moves_27__ = true;
                        self.since_rest = now_;
                    }
                }
                __CallsServedRegion1::Close => {
                    if inputs_.shut {
                        self.region_1 = __CallsServedRegion1::Rest;
                        moves_27__ = true;
                    } else {
                        if has_reached!(
                            passed_, Ticks::new(2000u32)
                        ) {
                            self.region_1 = __CallsServedRegion1::Serve;
                            next_served_ = {
                                let served = self.served;
                                served + 1
                            };
                            moves_27__ = true;
                            self.served = next_served_;
                            self.since_rest = now_;
                        }
                    }
                }
            }
            if !self.edge1_before && edge1_now_ {
                next_lamp_ = false;
            } else {
                if !self.edge0_before && inputs_.call {
                    next_lamp_ = true;
                }
            }
            moves_27__ = moves_27__ || self.lamp != next_lamp_;
            self.lamp = next_lamp_;
            if !moves_27__ {
                break;
            }
            self.edge0_before = inputs_.call;
            self.edge1_before = edge1_now_;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        self.edge0_before = inputs_.call;
        self.edge1_before = edge1_now_;
        match self.region_1 {
            __CallsServedRegion1::Run => {
                outputs_.drive = true;
            }
            __CallsServedRegion1::Serve => {
                outputs_.open = true;
            }
            _ => {}
        }
        outputs_.lamp = self.lamp;
        outputs_
    }
    /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
    /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
    /// "scan again at once"; `None` means "only an input can change anything".
    #[must_use]
    fn next_deadline(
        &self,
    ) -> Option<Ticks> {
        if !!(self.region_0 == __CallsServedRegion0::INIT) {
            return Option::Some(self.since_rest);
        }
        let mut soonest_ = Option::None;
        if self.region_1 == __CallsServedRegion1::Serve {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(500u32),
                ),
            );
        }
        if self.region_1 == __CallsServedRegion1::Close {
            soonest_ = sooner(
                soonest_,
                Option::Some(
                    Ticks::new(2000u32),
                ),
            );
        }
        match soonest_ {
            Option::Some(time_) => {
                Option::Some(self.since_rest.after(time_))
            }
            Option::None => Option::None,
        }
    }
}
