// Recorded by `cargo xtask bless`.

///The chart `Batch`.
#[cfg_attr(
    doc,
    doc = "\n\n<div style=\"overflow-x:auto\"><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4.5 -4.5 592 728\" style=\"width:592px;max-width:max(100%,355px);height:auto\" role=\"img\" aria-label=\"Chart Batch\"><g fill=\"none\" stroke=\"currentColor\"><path d=\"M12 8H68M100 56H116M100 184H116M412 184H428M100 408H116M100 568H116M12 712H68M60 134H388M60 138H388M60 326H388M60 330H388M12 8V712M68 8V40M68 72V134M68 138V168M68 200V326M68 330V392M68 424V552M68 584V712M116 584V616M132 600V616M148 40V72M148 168V200M148 392V424M148 552V584M148 616V648M156 200V232M156 456V488M180 424V456M380 138V168M380 200V326M460 168V200M460 264V296M484 200V264M68 96v16M68 352v16M68 512v16M68 672v16\"/><rect x=\"36\" y=\"40\" width=\"64\" height=\"32\"/><rect x=\"39\" y=\"43\" width=\"58\" height=\"26\"/><rect x=\"116\" y=\"40\" width=\"88\" height=\"32\"/><rect x=\"36\" y=\"168\" width=\"64\" height=\"32\"/><rect x=\"116\" y=\"168\" width=\"208\" height=\"32\"/><rect x=\"116\" y=\"200\" width=\"208\" height=\"32\"/><rect x=\"348\" y=\"168\" width=\"64\" height=\"32\"/><rect x=\"428\" y=\"168\" width=\"144\" height=\"32\"/><rect x=\"428\" y=\"200\" width=\"144\" height=\"32\"/><rect x=\"428\" y=\"232\" width=\"144\" height=\"32\"/><rect x=\"428\" y=\"264\" width=\"144\" height=\"32\"/><rect x=\"36\" y=\"392\" width=\"64\" height=\"32\"/><rect x=\"116\" y=\"392\" width=\"312\" height=\"32\"/><rect x=\"116\" y=\"424\" width=\"312\" height=\"32\"/><rect x=\"116\" y=\"456\" width=\"312\" height=\"32\"/><rect x=\"36\" y=\"552\" width=\"64\" height=\"32\"/><rect x=\"116\" y=\"552\" width=\"88\" height=\"32\"/><rect x=\"116\" y=\"616\" width=\"88\" height=\"32\"/><path d=\"M54 104h28M54 360h28M54 520h28M54 680h28\" stroke-width=\"3\"/></g><g fill=\"currentColor\" font-family=\"monospace\" font-size=\"13\" dominant-baseline=\"central\"><path d=\"M12 355l4 9h-8z\"/><text x=\"52\" y=\"56\" textLength=\"32\">Idle</text><text x=\"128\" y=\"56\" textLength=\"8\">N</text><text x=\"160\" y=\"56\" textLength=\"32\">lamp</text><text x=\"96\" y=\"104\" textLength=\"104\">rising(start)</text><text x=\"52\" y=\"184\" textLength=\"32\">Fill</text><text x=\"128\" y=\"184\" textLength=\"8\">N</text><text x=\"160\" y=\"184\" textLength=\"40\">valve</text><text x=\"128\" y=\"216\" textLength=\"16\">P1</text><text x=\"168\" y=\"216\" textLength=\"144\">count := count + 1</text><text x=\"364\" y=\"184\" textLength=\"32\">Heat</text><text x=\"440\" y=\"184\" textLength=\"8\">N</text><text x=\"472\" y=\"184\" textLength=\"72\">heat(hot)</text><text x=\"440\" y=\"216\" textLength=\"32\">L 3s</text><text x=\"496\" y=\"216\" textLength=\"32\">lamp</text><text x=\"440\" y=\"248\" textLength=\"32\">D 1s</text><text x=\"496\" y=\"248\" textLength=\"32\">pump</text><text x=\"440\" y=\"280\" textLength=\"8\">N</text><text x=\"472\" y=\"280\" textLength=\"88\">speed := 10</text><text x=\"96\" y=\"360\" textLength=\"136\">full &amp;&amp; soak/Heat</text><text x=\"52\" y=\"408\" textLength=\"32\">Stir</text><text x=\"128\" y=\"408\" textLength=\"8\">N</text><text x=\"160\" y=\"408\" textLength=\"64\">heat(40)</text><text x=\"128\" y=\"440\" textLength=\"40\">SD 2s</text><text x=\"192\" y=\"440\" textLength=\"32\">pump</text><text x=\"128\" y=\"472\" textLength=\"16\">P0</text><text x=\"168\" y=\"472\" textLength=\"248\">{ if count &gt; 3 { count = 0; } }</text><text x=\"96\" y=\"520\" textLength=\"240\">Stir.T &gt;= 2s &amp;&amp; 1s/empty/500ms</text><text x=\"48\" y=\"568\" textLength=\"40\">Drain</text><text x=\"128\" y=\"568\" textLength=\"8\">R</text><text x=\"160\" y=\"568\" textLength=\"32\">pump</text><text x=\"144\" y=\"600\" textLength=\"72\">level &gt; 3</text><text x=\"128\" y=\"632\" textLength=\"8\">N</text><text x=\"160\" y=\"632\" textLength=\"32\">pump</text><text x=\"96\" y=\"680\" textLength=\"80\">level == 0</text></g></svg></div>\n"
)]
/**

The situation takes 2 bytes: for each of these sets of steps, which of them is active, if any. No two of a set are active together.

- `Idle`, `Fill`, `Stir`, `Drain`
- `Heat`*/
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq
)]
#[repr(C)]
pub struct Batch {
    region_0: __BatchRegion0,
    region_1: __BatchRegion1,
    settled: ::grafcet::__private::bool,
    delay0_stage: ::grafcet::__private::u8,
    edge0_before: ::grafcet::__private::bool,
    was_q_heat: ::grafcet::__private::bool,
    acted_heat: ::grafcet::__private::u8,
    held_heat_3_: ::grafcet::__private::bool,
    held_stir_7_: ::grafcet::__private::bool,
    sd_ff_pump: ::grafcet::__private::bool,
    sd_tmr_pump_stage: ::grafcet::__private::u8,
    count: ::grafcet::__private::core::primitive::u16,
    reading: ::grafcet::__private::Ticks,
    time_heat: ::grafcet::__private::Ticks,
    since_idle: ::grafcet::__private::Ticks,
    delay0_since: ::grafcet::__private::Ticks,
    sd_tmr_pump_since: ::grafcet::__private::Ticks,
    params: BatchParams,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for Batch {}
impl Batch {
    ///A chart `Batch` in its initial situation; its activation belongs to the first cycle.
    #[must_use]
    pub const fn new() -> Self {
        Self::with_params(BatchParams::new())
    }
    ///A chart `Batch` in its initial situation, with this recipe.
    #[must_use]
    pub const fn with_params(
        #[cfg(not(doc))]
        params_: BatchParams,
        #[cfg(doc)]
        params: BatchParams,
    ) -> Self {
        #[cfg(doc)]
        let params_ = params;
        Self {
            region_0: __BatchRegion0::INIT,
            region_1: __BatchRegion1::NONE,
            count: 0,
            reading: ::grafcet::__private::Ticks::ZERO,
            settled: false,
            time_heat: ::grafcet::__private::Ticks::ZERO,
            since_idle: ::grafcet::__private::Ticks::ZERO,
            delay0_since: ::grafcet::__private::Ticks::ZERO,
            delay0_stage: 0,
            edge0_before: true,
            was_q_heat: false,
            acted_heat: 0,
            held_heat_3_: false,
            held_stir_7_: false,
            sd_ff_pump: false,
            sd_tmr_pump_since: ::grafcet::__private::Ticks::ZERO,
            sd_tmr_pump_stage: 0,
            params: params_,
        }
    }
    /// The recipe in use.
    #[must_use]
    pub const fn params(&self) -> &BatchParams {
        &self.params
    }
    /// Exchanges the recipe; the next cycle uses the new one.
    pub fn set_params(
        &mut self,
        #[cfg(not(doc))]
        params_: BatchParams,
        #[cfg(doc)]
        params: BatchParams,
    ) {
        self.params = params_;
    }
}
impl ::grafcet::__private::core::default::Default for Batch {
    fn default() -> Self {
        Self::new()
    }
}
///The process inputs of [`Batch`], sampled once per cycle.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::default::Default
)]
pub struct BatchInputs {
    ///Input `start`.
    pub start: ::grafcet::__private::core::primitive::bool,
    ///Input `full`.
    pub full: ::grafcet::__private::core::primitive::bool,
    ///Input `empty`.
    pub empty: ::grafcet::__private::core::primitive::bool,
    ///Input `level`.
    pub level: ::grafcet::__private::core::primitive::u16,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for BatchInputs {}
impl BatchInputs {
    /// The default inputs, for constants and statics.
    pub const DEFAULT: Self = Self {
        start: false,
        full: false,
        empty: false,
        level: 0,
    };
}
///The process outputs of [`Batch`]; `default()` holds the initial values.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct BatchOutputs {
    ///Output `valve`.
    pub valve: ::grafcet::__private::core::primitive::bool,
    ///Output `pump`.
    pub pump: ::grafcet::__private::core::primitive::bool,
    ///Output `lamp`.
    pub lamp: ::grafcet::__private::core::primitive::bool,
    ///Output `speed`.
    pub speed: ::grafcet::__private::core::primitive::u16,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for BatchOutputs {}
impl ::grafcet::__private::core::default::Default for BatchOutputs {
    fn default() -> Self {
        Self {
            valve: false,
            pump: false,
            lamp: false,
            speed: 0,
        }
    }
}
///The names of the steps of [`Batch`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash
)]
pub enum BatchStep {
    ///Step `Idle`.
    Idle,
    ///Step `Fill`.
    Fill,
    ///Step `Heat`.
    Heat,
    ///Step `Stir`.
    Stir,
    ///Step `Drain`.
    Drain,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for BatchStep {}
impl BatchStep {
    /// The name as it is written.
    #[must_use]
    pub const fn name(self) -> &'static ::grafcet::__private::str {
        ::grafcet::__private::name_at(
            &["Idle", "Fill", "Heat", "Stir", "Drain"],
            self as ::grafcet::__private::usize,
        )
    }
}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for BatchStep {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str((*self).name())
    }
}
impl ::grafcet::__private::core::fmt::Display for BatchStep {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.pad((*self).name())
    }
}
///The names of the transitions of [`Batch`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash
)]
pub enum BatchTransition {
    ///`Idle -[rising(start)]-> (Fill, Heat)`
    IdleToFillAndHeat,
    ///`(Fill, Heat) -[full && soak/Heat]-> Stir`
    FillAndHeatToStir,
    ///`Stir -[Stir.T >= 2s && 1s/empty/500ms]-> Drain`
    StirToDrain,
    ///`Drain -[level == 0]-> Idle`
    DrainToIdle,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for BatchTransition {}
impl BatchTransition {
    /// The name as it is written.
    #[must_use]
    pub const fn name(self) -> &'static ::grafcet::__private::str {
        ::grafcet::__private::name_at(
            &["IdleToFillAndHeat", "FillAndHeatToStir", "StirToDrain", "DrainToIdle"],
            self as ::grafcet::__private::usize,
        )
    }
}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for BatchTransition {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str((*self).name())
    }
}
impl ::grafcet::__private::core::fmt::Display for BatchTransition {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.pad((*self).name())
    }
}
///The recipe of [`Batch`]; `default()` holds the values in the chart.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct BatchParams {
    ///Parameter `soak`.
    pub soak: ::grafcet::__private::Ticks,
    ///Parameter `hot`.
    pub hot: ::grafcet::__private::core::primitive::i16,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for BatchParams {}
impl BatchParams {
    /// The values in the chart.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            soak: {
                let ticks_5000_ = ::grafcet::__private::Ticks::new(5000u32);
                ticks_5000_
            },
            hot: 80,
        }
    }
}
impl ::grafcet::__private::core::default::Default for BatchParams {
    fn default() -> Self {
        Self::new()
    }
}
///The code actions of [`Batch`], carried out by the program.
pub trait BatchActions {
    ///Action `heat`; `phase` tells which call this is.
    fn heat(
        &mut self,
        phase: ::grafcet::__private::Phase,
        setpoint: ::grafcet::__private::core::primitive::i16,
    );
}
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq
)]
#[doc(hidden)]
enum __BatchRegion0 {
    Idle,
    Fill,
    Stir,
    Drain,
    INIT,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for __BatchRegion0 {}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for __BatchRegion0 {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str(
            ::grafcet::__private::name_at(
                &["Idle", "Fill", "Stir", "Drain", "INIT"],
                *self as ::grafcet::__private::usize,
            ),
        )
    }
}
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq
)]
#[doc(hidden)]
enum __BatchRegion1 {
    Heat,
    NONE,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for __BatchRegion1 {}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for __BatchRegion1 {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str(
            ::grafcet::__private::name_at(
                &["Heat", "NONE"],
                *self as ::grafcet::__private::usize,
            ),
        )
    }
}
///A situation of [`Batch`]: which steps are active.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct BatchSituation {
    region_0: __BatchRegion0,
    region_1: __BatchRegion1,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for BatchSituation {}
impl BatchSituation {
    /// Whether the step is active in this situation.
    #[must_use]
    pub fn is_active(
        &self,
        #[cfg(not(doc))]
        step_: BatchStep,
        #[cfg(doc)]
        step: BatchStep,
    ) -> ::grafcet::__private::bool {
        match step_ {
            BatchStep::Idle => self.region_0 == __BatchRegion0::Idle,
            BatchStep::Fill => self.region_0 == __BatchRegion0::Fill,
            BatchStep::Heat => self.region_1 == __BatchRegion1::Heat,
            BatchStep::Stir => self.region_0 == __BatchRegion0::Stir,
            BatchStep::Drain => self.region_0 == __BatchRegion0::Drain,
        }
    }
}
impl ::grafcet::__private::core::fmt::Debug for BatchSituation {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        let mut set_ = f_.debug_set();
        for step_ in <Batch as ::grafcet::__private::Chart>::STEPS {
            if self.is_active(*step_) {
                let _ = ::grafcet::__private::core::fmt::DebugSet::entry(
                    &mut set_,
                    step_,
                );
            }
        }
        ::grafcet::__private::core::fmt::DebugSet::finish(&mut set_)
    }
}
/// The names of the active steps, as in `Fill, Heat`; nothing where none is active.
impl ::grafcet::__private::core::fmt::Display for BatchSituation {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        let names_ = ::grafcet::__private::core::iter::Iterator::map(
            <Batch as ::grafcet::__private::Chart>::STEPS.iter(),
            |step_| (*step_).name(),
        );
        ::grafcet::__private::situation::write(self, names_, f_)
    }
}
impl Batch {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &BatchInputs,
        #[cfg(doc)]
        inputs: &BatchInputs,
        #[cfg(not(doc))]
        now_: impl ::grafcet::__private::core::convert::Into<
            ::grafcet::__private::Ticks,
        >,
        #[cfg(doc)]
        now: impl ::grafcet::__private::core::convert::Into<::grafcet::__private::Ticks>,
        #[cfg(not(doc))]
        actions_: &mut (impl BatchActions + ?::grafcet::__private::core::marker::Sized),
        #[cfg(doc)]
        actions: &mut (impl BatchActions + ?::grafcet::__private::core::marker::Sized),
    ) -> BatchOutputs {
        let now_: ::grafcet::__private::Ticks = ::grafcet::__private::core::convert::Into::into(
            now_,
        );
        let mut outputs_ = BatchOutputs {
            valve: false,
            pump: false,
            lamp: false,
            speed: 0,
        };
        if inputs_.empty {
            if self.delay0_stage == 3 {
                self.delay0_stage = 2;
            } else {
                if self.delay0_stage == 0 {
                    self.delay0_since = now_;
                    self.delay0_stage = 1;
                } else {
                    if self.delay0_stage == 1
                        && ::grafcet::__private::has_reached!(
                            now_.since(self.delay0_since),
                            ::grafcet::__private::Ticks::new(1000u32)
                        )
                    {
                        self.delay0_stage = 2;
                    }
                }
            }
        } else {
            if self.delay0_stage == 1 {
                self.delay0_stage = 0;
            } else {
                if self.delay0_stage == 2 {
                    self.delay0_since = now_;
                    self.delay0_stage = 3;
                } else {
                    if self.delay0_stage == 3
                        && ::grafcet::__private::has_reached!(
                            now_.since(self.delay0_since),
                            ::grafcet::__private::Ticks::new(500u32)
                        )
                    {
                        self.delay0_stage = 0;
                    }
                }
            }
        }
        ::grafcet::__private::core::sync::atomic::compiler_fence(
            ::grafcet::__private::core::sync::atomic::Ordering::SeqCst,
        );
        let elapsed_: ::grafcet::__private::Ticks = now_.since(self.reading);
        self.reading = now_;
        ::grafcet::__private::fence_beyond_armv6m();
        self.time_heat = self.time_heat + elapsed_;
        let mut any_68__: ::grafcet::__private::bool = false;
        match self.region_0 {
            __BatchRegion0::INIT => {
                self.time_heat = ::grafcet::__private::Ticks::ZERO;
                self.region_0 = __BatchRegion0::Idle;
                any_68__ = true;
            }
            __BatchRegion0::Idle => {
                if !self.edge0_before && inputs_.start {
                    self.region_0 = __BatchRegion0::Fill;
                    self.region_1 = __BatchRegion1::Heat;
                    self.time_heat = ::grafcet::__private::Ticks::ZERO;
                    self.count = {
                        let count = self.count;
                        count + 1
                    };
                    any_68__ = true;
                }
            }
            __BatchRegion0::Stir => {
                if ({
                    let since_3_ = self.reading.since(self.since_idle);
                    let ticks_2000_ = ::grafcet::__private::Ticks::new(2000u32);
                    since_3_ >= ticks_2000_
                }) && self.delay0_stage >= 2
                {
                    self.region_0 = __BatchRegion0::Drain;
                    {
                        #[allow(unused_mut, unused_variables)]
                        let mut count = self.count;
                        #[allow(unused_braces)]
                        {
                            if count > 3 {
                                count = 0;
                            }
                        }
                        self.count = count;
                    }
                    any_68__ = true;
                } else {
                    if ::grafcet::__private::has_reached!(
                        self.reading.since(self.since_idle),
                        ::grafcet::__private::Ticks::new(2000u32)
                    ) {
                        self.since_idle = self
                            .reading
                            .since(::grafcet::__private::Ticks::new(2000u32));
                    }
                }
            }
            __BatchRegion0::Drain => {
                if {
                    let level = inputs_.level;
                    level == 0
                } {
                    self.region_0 = __BatchRegion0::Idle;
                    any_68__ = true;
                }
            }
            _ => {
                match self.region_1 {
                    __BatchRegion1::Heat => {
                        if inputs_.full && self.time_heat >= self.params.soak {
                            self.region_1 = __BatchRegion1::NONE;
                            self.region_0 = __BatchRegion0::Stir;
                            self.since_idle = self.reading;
                            any_68__ = true;
                        }
                    }
                    _ => {}
                }
            }
        }
        self.edge0_before = inputs_.start;
        ::grafcet::__private::core::sync::atomic::compiler_fence(
            ::grafcet::__private::core::sync::atomic::Ordering::SeqCst,
        );
        let mut q_heat_: ::grafcet::__private::bool = false;
        let mut on_stir_7__: ::grafcet::__private::bool = false;
        let mut on_drain_10__: ::grafcet::__private::bool = false;
        let mut on_drain_11__: ::grafcet::__private::bool = false;
        match self.region_0 {
            __BatchRegion0::Idle => {
                outputs_.lamp = true;
            }
            __BatchRegion0::Fill => {
                outputs_.valve = true;
            }
            __BatchRegion0::Stir => {
                on_stir_7__ = true;
                q_heat_ = true;
                self.sd_ff_pump = true;
            }
            __BatchRegion0::Drain => {
                on_drain_10__ = true;
                on_drain_11__ = {
                    let level = inputs_.level;
                    level > 3
                };
                self.sd_ff_pump = false;
            }
            _ => {}
        }
        if self.sd_ff_pump {
            if self.sd_tmr_pump_stage == 0 {
                self.sd_tmr_pump_since = self.reading;
                self.sd_tmr_pump_stage = 1;
            } else {
                if self.sd_tmr_pump_stage == 1
                    && ::grafcet::__private::has_reached!(
                        self.reading.since(self.sd_tmr_pump_since),
                        ::grafcet::__private::Ticks::new(2000u32)
                    )
                {
                    self.sd_tmr_pump_stage = 2;
                }
            }
        } else {
            self.sd_tmr_pump_stage = 0;
        }
        let mut on_heat_3__: ::grafcet::__private::bool = false;
        let mut on_heat_5__: ::grafcet::__private::bool = false;
        match self.region_1 {
            __BatchRegion1::Heat => {
                on_heat_3__ = true;
                on_heat_5__ = true;
                outputs_.lamp = outputs_.lamp
                    || self.time_heat < ::grafcet::__private::Ticks::new(3000u32);
                q_heat_ = true;
                outputs_.speed = 10;
            }
            _ => {}
        }
        if q_heat_ {
            if on_heat_3__ {
                self.acted_heat = 3;
            }
            if on_stir_7__ {
                self.acted_heat = 7;
            }
        }
        let by_leaving_heat_: ::grafcet::__private::bool = self.was_q_heat && !q_heat_
            && (self.held_heat_3_ && self.region_1 != __BatchRegion1::Heat
                && !(on_heat_3__ || on_stir_7__)
                || self.held_stir_7_ && self.region_0 != __BatchRegion0::Stir
                    && !(on_heat_3__ || on_stir_7__));
        self.held_heat_3_ = q_heat_ && on_heat_3__;
        self.held_stir_7_ = q_heat_ && on_stir_7__;
        outputs_.pump = !on_drain_10__
            && (on_drain_11__
                || on_heat_5__
                    && self.time_heat >= ::grafcet::__private::Ticks::new(1000u32)
                || self.sd_tmr_pump_stage == 2);
        let mut opaque_ran_: ::grafcet::__private::bool = false;
        if by_leaving_heat_ {
            match self.acted_heat {
                3 => {
                    actions_
                        .heat(
                            ::grafcet::__private::Phase::Final,
                            {
                                let hot = self.params.hot;
                                hot
                            },
                        );
                    opaque_ran_ = true;
                }
                _ => {
                    actions_.heat(::grafcet::__private::Phase::Final, 40);
                    opaque_ran_ = true;
                }
            }
        }
        if q_heat_ {
            match self.acted_heat {
                3 => {
                    actions_
                        .heat(
                            if self.was_q_heat {
                                ::grafcet::__private::Phase::Repeated
                            } else {
                                ::grafcet::__private::Phase::First
                            },
                            {
                                let hot = self.params.hot;
                                hot
                            },
                        );
                    opaque_ran_ = true;
                }
                _ => {
                    actions_
                        .heat(
                            if self.was_q_heat {
                                ::grafcet::__private::Phase::Repeated
                            } else {
                                ::grafcet::__private::Phase::First
                            },
                            40,
                        );
                    opaque_ran_ = true;
                }
            }
        } else {
            if self.was_q_heat && !by_leaving_heat_ {
                match self.acted_heat {
                    3 => {
                        actions_
                            .heat(
                                ::grafcet::__private::Phase::Final,
                                {
                                    let hot = self.params.hot;
                                    hot
                                },
                            );
                        opaque_ran_ = true;
                    }
                    _ => {
                        actions_.heat(::grafcet::__private::Phase::Final, 40);
                        opaque_ran_ = true;
                    }
                }
            }
        }
        self.was_q_heat = q_heat_;
        any_68__ = any_68__ || opaque_ran_;
        self.settled = !any_68__;
        outputs_
    }
    /// Back to the initial situation (the classic *Init*), stored outputs and variables reset; the next cycle is a
    /// first one.
    pub fn init(&mut self) {
        *self = Self::with_params(self.params);
    }
    /// Whether the step is active.
    #[must_use]
    pub fn is_active(
        &self,
        #[cfg(not(doc))]
        step_: BatchStep,
        #[cfg(doc)]
        step: BatchStep,
    ) -> ::grafcet::__private::bool {
        match step_ {
            BatchStep::Idle => {
                self.region_0 == __BatchRegion0::Idle
                    || self.region_0 == __BatchRegion0::INIT
            }
            BatchStep::Fill => self.region_0 == __BatchRegion0::Fill,
            BatchStep::Heat => self.region_1 == __BatchRegion1::Heat,
            BatchStep::Stir => self.region_0 == __BatchRegion0::Stir,
            BatchStep::Drain => self.region_0 == __BatchRegion0::Drain,
        }
    }
    /// The active steps, in the order of their declaration; the capacity is the most that can be active.
    #[must_use]
    pub fn active_steps(&self) -> ::grafcet::__private::heapless::Vec<BatchStep, 2> {
        let mut steps_ = ::grafcet::__private::heapless::Vec::new();
        if self.region_0 == __BatchRegion0::Idle || self.region_0 == __BatchRegion0::INIT
        {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                BatchStep::Idle,
            );
        }
        if self.region_0 == __BatchRegion0::Fill {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                BatchStep::Fill,
            );
        }
        if self.region_1 == __BatchRegion1::Heat {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                BatchStep::Heat,
            );
        }
        if self.region_0 == __BatchRegion0::Stir {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                BatchStep::Stir,
            );
        }
        if self.region_0 == __BatchRegion0::Drain {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                BatchStep::Drain,
            );
        }
        steps_
    }
    /// The situation: which steps are active.
    #[must_use]
    pub const fn situation(&self) -> BatchSituation {
        BatchSituation {
            region_0: match self.region_0 {
                __BatchRegion0::INIT => __BatchRegion0::Idle,
                entered_ => entered_,
            },
            region_1: self.region_1,
        }
    }
    /// Whether these steps are active, in any order, and no others: the same question for one active step and
    /// for several.
    #[must_use]
    pub fn is_exactly(
        &self,
        #[cfg(not(doc))]
        steps_: &[BatchStep],
        #[cfg(doc)]
        steps: &[BatchStep],
    ) -> ::grafcet::__private::bool {
        ::grafcet::__private::Chart::is_exactly(self, steps_)
    }
    /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
    /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
    /// "scan again at once"; `None` means "only an input can change anything".
    #[must_use]
    pub fn next_deadline(
        &self,
    ) -> ::grafcet::__private::Option<::grafcet::__private::Ticks> {
        if !self.settled {
            return ::grafcet::__private::Option::Some(self.reading);
        }
        let mut soonest_ = ::grafcet::__private::Option::None;
        if self.region_1 == __BatchRegion1::Heat
            && self.time_heat < ::grafcet::__private::Ticks::new(1000u32)
        {
            soonest_ = ::grafcet::__private::sooner(
                soonest_,
                ::grafcet::__private::Option::Some(
                    ::grafcet::__private::Ticks::new(1000u32) - self.time_heat,
                ),
            );
        }
        if self.region_1 == __BatchRegion1::Heat
            && self.time_heat < ::grafcet::__private::Ticks::new(3000u32)
        {
            soonest_ = ::grafcet::__private::sooner(
                soonest_,
                ::grafcet::__private::Option::Some(
                    ::grafcet::__private::Ticks::new(3000u32) - self.time_heat,
                ),
            );
        }
        if self.region_1 == __BatchRegion1::Heat && self.time_heat < self.params.soak {
            soonest_ = ::grafcet::__private::sooner(
                soonest_,
                ::grafcet::__private::Option::Some(self.params.soak - self.time_heat),
            );
        }
        if self.region_0 == __BatchRegion0::Stir
            && self.reading.since(self.since_idle)
                < ::grafcet::__private::Ticks::new(2000u32)
        {
            soonest_ = ::grafcet::__private::sooner(
                soonest_,
                ::grafcet::__private::Option::Some(
                    ::grafcet::__private::Ticks::new(2000u32)
                        - self.reading.since(self.since_idle),
                ),
            );
        }
        if self.delay0_stage == 1 {
            soonest_ = ::grafcet::__private::sooner(
                soonest_,
                ::grafcet::__private::Option::Some(
                    ::grafcet::__private::Ticks::new(1000u32)
                        - self.reading.since(self.delay0_since),
                ),
            );
        }
        if self.delay0_stage == 3 {
            soonest_ = ::grafcet::__private::sooner(
                soonest_,
                ::grafcet::__private::Option::Some(
                    ::grafcet::__private::Ticks::new(500u32)
                        - self.reading.since(self.delay0_since),
                ),
            );
        }
        if self.sd_tmr_pump_stage == 1 {
            soonest_ = ::grafcet::__private::sooner(
                soonest_,
                ::grafcet::__private::Option::Some(
                    ::grafcet::__private::Ticks::new(2000u32)
                        - self.reading.since(self.sd_tmr_pump_since),
                ),
            );
        }
        match soonest_ {
            ::grafcet::__private::Option::Some(time_) => {
                ::grafcet::__private::Option::Some(self.reading.after(time_))
            }
            ::grafcet::__private::Option::None => ::grafcet::__private::Option::None,
        }
    }
    /// A duration in the chart's clock unit, rounded up.
    #[must_use]
    pub const fn ticks(
        #[cfg(not(doc))]
        duration_: ::grafcet::__private::core::time::Duration,
        #[cfg(doc)]
        duration: ::grafcet::__private::core::time::Duration,
    ) -> ::grafcet::__private::Ticks {
        #[cfg(doc)]
        let duration_ = duration;
        ::grafcet::__private::Ticks::from_duration(duration_, 1000000)
    }
}
///The variables of [`Batch`], as the last cycle has left them.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct BatchVars {
    ///Variable `count`.
    pub count: ::grafcet::__private::core::primitive::u16,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for BatchVars {}
impl Batch {
    /// The variables, as the last cycle has left them.
    #[must_use]
    pub fn vars(&self) -> BatchVars {
        BatchVars { count: self.count }
    }
}
impl ::grafcet::__private::Chart for Batch {
    type Inputs = BatchInputs;
    type Outputs = BatchOutputs;
    type Step = BatchStep;
    type Transition = BatchTransition;
    type Situation = BatchSituation;
    type Actions<'a> = dyn BatchActions + 'a;
    const NAME: &'static ::grafcet::__private::str = "Batch";
    const STEPS: &'static [BatchStep] = &[
        BatchStep::Idle,
        BatchStep::Fill,
        BatchStep::Heat,
        BatchStep::Stir,
        BatchStep::Drain,
    ];
    const TRANSITIONS: &'static [BatchTransition] = &[
        BatchTransition::IdleToFillAndHeat,
        BatchTransition::FillAndHeatToStir,
        BatchTransition::StirToDrain,
        BatchTransition::DrainToIdle,
    ];
    fn scan(
        &mut self,
        inputs_: &BatchInputs,
        now_: ::grafcet::__private::Ticks,
        actions_: &mut Self::Actions<'_>,
    ) -> BatchOutputs {
        self.cycle(inputs_, now_, actions_)
    }
    fn init(&mut self) {
        self.init();
    }
    fn is_active(&self, step_: BatchStep) -> ::grafcet::__private::bool {
        self.is_active(step_)
    }
    fn situation(&self) -> BatchSituation {
        self.situation()
    }
}
impl Batch {
    /// What the chart looks like: its steps, transitions and actions as they stand in the source.
    pub const CHART: ::grafcet::__private::description::Description<'static> = ::grafcet::__private::description::table::Described::<
        Batch,
        12,
        0,
        10,
        1,
        0,
        5,
        4,
        0,
    >::sfc();
}
impl ::grafcet::__private::description::table::Tables for Batch {
    const TEXTS: &'static [&'static ::grafcet::__private::str] = &[
        "",
        "1s",
        "2s",
        "3s",
        "Batch",
        "D",
        "Drain",
        "Fill",
        "Heat",
        "Idle",
        "L",
        "N",
        "P0",
        "P1",
        "R",
        "SD",
        "Stir",
        "Stir.T >= 2s && 1s/empty/500ms",
        "count = count + 1",
        "full && soak/Heat",
        "heat(40)",
        "heat(hot)",
        "lamp",
        "level == 0",
        "level > 3",
        "pump",
        "rising(start)",
        "speed = 10",
        "valve",
        "{ if count > 3 { count = 0; } }",
    ];
    const NUMBERS: &'static [::grafcet::__private::u8] = b"\x0B\0\0\x16\x0B\0\0\x1C\r\0\0\x12\x0B\0\0\x15\n\x03\0\x16\x05\x01\0\x19\x0B\0\0\x1B\x0B\0\0\x14\x0F\x02\0\x19\x0C\0\0\x1D\x0E\0\0\x19\x0B\0\x18\x19\0\x01\x02\x01\x02\x03\x03\x04\x04\0\x04\0\0\0\t\x01\0\0\x01\0\0\x07\0\0\0\x02\0\0\x08\0\0\0\x04\0\0\x10\0\0\0\x03\0\0\x06\0\0\0\x02\0\0\0\x1A\x01\x02\0\0\0\x13\x02\x01\0\0\0\x11\x01\x01\0\0\0\x17\x01\x01\0\0";
}
impl ::grafcet::__private::ActiveSteps for BatchSituation {
    fn is_active_at(
        &self,
        step_: ::grafcet::__private::usize,
    ) -> ::grafcet::__private::bool {
        match ::grafcet::__private::step_at::<Batch>(step_) {
            ::grafcet::__private::Option::Some(active_) => self.is_active(active_),
            ::grafcet::__private::Option::None => false,
        }
    }
}
#[allow(unexpected_cfgs)]
const _: () = {
    #[cfg(rust_analyzer)]
    fn mentions<A: BatchActions + ?::grafcet::__private::core::marker::Sized>(
        inputs_: &BatchInputs,
        params_: &BatchParams,
        outputs_: &BatchOutputs,
    ) {
        let _ = [
            BatchStep::Idle,
            BatchStep::Fill,
            BatchStep::Heat,
            BatchStep::Fill,
            BatchStep::Heat,
            BatchStep::Stir,
            BatchStep::Drain,
            BatchStep::Idle,
            BatchStep::Heat,
            BatchStep::Stir,
        ];
        let _ = (
            &inputs_.level,
            &inputs_.start,
            &inputs_.full,
            &inputs_.empty,
            &inputs_.level,
        );
        let _ = (&params_.hot,);
        let _ = (
            &outputs_.lamp,
            &outputs_.valve,
            &outputs_.lamp,
            &outputs_.pump,
            &outputs_.speed,
            &outputs_.pump,
            &outputs_.pump,
            &outputs_.pump,
        );
        let _ = (A::heat, A::heat);
        {
            struct Variables {
                count: ::grafcet::__private::core::primitive::u16,
            }
            fn mentions(variables_: &Variables) {
                let _ = (
                    &variables_.count,
                    &variables_.count,
                    &variables_.count,
                    &variables_.count,
                    &variables_.count,
                );
            }
        }
    }
};
