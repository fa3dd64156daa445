// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Presses {
    /// One cycle: evaluates the transition conditions on `inputs`, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(&mut self, inputs: &PressesInputs) -> PressesOutputs {
        let mut outputs = PressesOutputs {
            left: false,
            right: false,
        };
        self.region_0 = self.region_0.unmarked();
        let mut evolutions_left: u32 = 12;
        let inputs = core::hint::black_box(inputs);
        loop {
            core::sync::atomic::compiler_fence(
                core::sync::atomic::Ordering::SeqCst,
            );
            #[allow(unused_variables)]
            let before_0 = self.region_0.state();
            #[allow(unused_variables)]
            let before_1 = self.region_1;
            let mut moved = false;
            let kept_region_0 = self.region_0;
            let kept_region_1 = self.region_1;
            match self.region_0.state() {
                __PressesRegion0::Wait => {
                    if inputs.start {
                        self.region_0 = __PressesRegion0Mark::of(__PressesRegion0::Left);
                        self.region_1 = __PressesRegion1::Right;
                        moved = true;
                    }
                }
                _ => {
                    if self.region_0.state() == __PressesRegion0::LeftReady
                        && self.region_1 == __PressesRegion1::RightReady
                    {
                        self.region_1 = __PressesRegion1::NONE;
                        self.region_0 = __PressesRegion0Mark::of(__PressesRegion0::Wait);
                        moved = true;
                    } else {
                        match self.region_0.state() {
                            __PressesRegion0::Left => {
                                if inputs.left_done {
                                    self.region_0 = __PressesRegion0Mark::of(
                                        __PressesRegion0::LeftReady,
                                    );
                                    moved = true;
                                }
                            }
                            _ => {}
                        }
                        match self.region_1 {
                            __PressesRegion1::Right => {
                                if inputs.right_done {
                                    self.region_1 = __PressesRegion1::RightReady;
                                    moved = true;
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
            #[allow(unused_variables)]
            let after_0 = self.region_0.state();
            #[allow(unused_variables)]
            let after_1 = self.region_1;
            if !moved {
                break;
            }
            if evolutions_left == 0 {
                self.region_0 = kept_region_0;
                self.region_1 = kept_region_1;
                self.region_0 = self.region_0.marked();
                break;
            }
            evolutions_left -= 1;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        #[allow(unused_variables)]
        let after_0 = self.region_0.state();
        #[allow(unused_variables)]
        let after_1 = self.region_1;
        match self.region_0.state() {
            __PressesRegion0::Wait => {}
            _ => {
                match self.region_0.state() {
                    __PressesRegion0::Left => {
                        outputs.left = true;
                    }
                    _ => {}
                }
                match self.region_1 {
                    __PressesRegion1::Right => {
                        outputs.right = true;
                    }
                    _ => {}
                }
            }
        }
        outputs
    }
}
