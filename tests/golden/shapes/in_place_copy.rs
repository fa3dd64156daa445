// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Presses {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &PressesInputs) -> PressesOutputs {
        let outputs = PressesOutputs {};
        self.region_0 = self.region_0.unmarked();
        let mut evolutions_left: u32 = 20;
        loop {
            core::sync::atomic::compiler_fence(
                core::sync::atomic::Ordering::SeqCst,
            );
            #[allow(unused_variables)]
            let before_0 = self.region_0.state();
            #[allow(unused_variables)]
            let before_1 = self.region_1;
            #[allow(unused_variables)]
            let before_2 = self.region_2;
            #[allow(unused_variables)]
            let before_3 = self.region_3;
            if evolutions_left == 0 {
                let mut copy = *self;
                if copy.__evolve(inputs) {
                    self.region_0 = self.region_0.marked();
                }
                break;
            }
            if !self.__evolve(inputs) {
                break;
            }
            #[allow(unused_variables)]
            let after_0 = self.region_0.state();
            #[allow(unused_variables)]
            let after_1 = self.region_1;
            #[allow(unused_variables)]
            let after_2 = self.region_2;
            #[allow(unused_variables)]
            let after_3 = self.region_3;
            evolutions_left -= 1;
        }
        outputs
    }
    /// One evolution; whether it has changed the situation.
    #[inline(never)]
    fn __evolve(&mut self, inputs: &PressesInputs) -> bool {
        let mut moved = false;
        #[allow(unused_variables)]
        let before_0 = self.region_0.state();
        #[allow(unused_variables)]
        let before_1 = self.region_1;
        #[allow(unused_variables)]
        let before_2 = self.region_2;
        #[allow(unused_variables)]
        let before_3 = self.region_3;
        match self.region_0.state() {
            __PressesRegion0::Wait => {
                if inputs.start {
                    self.region_0 = __PressesRegion0Mark::of(__PressesRegion0::One);
                    self.region_1 = __PressesRegion1::Two;
                    self.region_2 = __PressesRegion2::Three;
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    self.region_3 = __PressesRegion3::Four;
                    moved = true;
                }
            }
            _ => {
                if self.region_0.state() == __PressesRegion0::OneReady
                    && self.region_1 == __PressesRegion1::TwoReady
                    && self.region_2 == __PressesRegion2::ThreeReady
                    && self.region_3 == __PressesRegion3::FourReady
                {
                    self.region_1 = __PressesRegion1::NONE;
                    self.region_2 = __PressesRegion2::NONE;
                    self.region_3 = __PressesRegion3::NONE;
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    self.region_0 = __PressesRegion0Mark::of(__PressesRegion0::Wait);
                    moved = true;
                } else {
                    match self.region_0.state() {
                        __PressesRegion0::One => {
                            if inputs.one_done {
                                self.region_0 = __PressesRegion0Mark::of(
                                    __PressesRegion0::OneReady,
                                );
                                moved = true;
                            }
                        }
                        _ => {}
                    }
                    match self.region_1 {
                        __PressesRegion1::Two => {
                            if inputs.two_done {
                                self.region_1 = __PressesRegion1::TwoReady;
                                moved = true;
                            }
                        }
                        _ => {}
                    }
                    match self.region_2 {
                        __PressesRegion2::Three => {
                            if inputs.three_done {
                                self.region_2 = __PressesRegion2::ThreeReady;
                                moved = true;
                            }
                        }
                        _ => {}
                    }
                    match self.region_3 {
                        __PressesRegion3::Four => {
                            if inputs.four_done {
                                self.region_3 = __PressesRegion3::FourReady;
                                moved = true;
                            }
                        }
                        _ => {}
                    }
                }
            }
        }
        moved
    }
}
