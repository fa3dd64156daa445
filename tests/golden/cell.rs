// Recorded by `cargo xtask bless`.

///The chart `Cell`.
#[cfg_attr(
    doc,
    doc = "\n\n<div style=\"overflow-x:auto\"><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4.5 -4.5 776 696\" style=\"width:776px;max-width:max(100%,465px);height:auto\" role=\"img\" aria-label=\"Chart Cell\"><g fill=\"none\" stroke=\"currentColor\"><path d=\"M28 56H92M132 200H148M132 328H148M28 408H92M28 56V408M92 56V88M92 120V184M92 216V312M92 344V408M92 144v16M92 272v16M92 368v16M380 56H436M436 152H596M468 248H484M628 248H644M380 440H596M380 56V440M436 56V88M436 120V232M436 264V344M436 376V440M596 152V232M596 264V440M660 216V232M436 176v16M596 176v16M564 239l7 -7M621 232l7 7M628 257l-7 7M571 264l-7 -7M436 288v16M596 288v16M404 349h64M404 371h64M436 400v16M84 536H100M84 632H100M52 552V616M132 520V552M132 616V648M52 576v16M380 584H396M412 552V568M428 568V600\"/><rect x=\"4\" y=\"8\" width=\"328\" height=\"432\" stroke-opacity=\".35\" rx=\"4\"/><rect x=\"60\" y=\"88\" width=\"64\" height=\"32\"/><rect x=\"63\" y=\"91\" width=\"58\" height=\"26\"/><rect x=\"52\" y=\"184\" width=\"80\" height=\"32\"/><rect x=\"148\" y=\"184\" width=\"128\" height=\"32\"/><rect x=\"148\" y=\"216\" width=\"128\" height=\"32\"/><rect x=\"151\" y=\"219\" width=\"122\" height=\"26\"/><rect x=\"52\" y=\"312\" width=\"80\" height=\"32\"/><rect x=\"148\" y=\"312\" width=\"160\" height=\"32\"/><rect x=\"151\" y=\"315\" width=\"154\" height=\"26\"/><rect x=\"356\" y=\"8\" width=\"408\" height=\"464\" stroke-opacity=\".35\" rx=\"4\"/><rect x=\"404\" y=\"88\" width=\"64\" height=\"32\"/><rect x=\"407\" y=\"91\" width=\"58\" height=\"26\"/><rect x=\"404\" y=\"232\" width=\"64\" height=\"32\"/><rect x=\"484\" y=\"232\" width=\"56\" height=\"32\"/><rect x=\"564\" y=\"232\" width=\"64\" height=\"32\"/><rect x=\"644\" y=\"232\" width=\"56\" height=\"32\"/><rect x=\"404\" y=\"344\" width=\"64\" height=\"32\"/><rect x=\"4\" y=\"472\" width=\"256\" height=\"208\" stroke-opacity=\".35\" rx=\"4\"/><rect x=\"20\" y=\"520\" width=\"64\" height=\"32\"/><rect x=\"100\" y=\"520\" width=\"136\" height=\"32\"/><rect x=\"20\" y=\"616\" width=\"64\" height=\"32\"/><rect x=\"100\" y=\"616\" width=\"136\" height=\"32\"/><rect x=\"284\" y=\"504\" width=\"272\" height=\"128\" stroke-opacity=\".35\" rx=\"4\"/><rect x=\"316\" y=\"568\" width=\"64\" height=\"32\"/><rect x=\"396\" y=\"568\" width=\"136\" height=\"32\"/><path d=\"M78 152h28M78 280h28M78 376h28M422 184h28M582 184h28M422 296h28M582 296h28M422 408h28M38 584h28\" stroke-width=\"3\"/></g><g fill=\"currentColor\" font-family=\"monospace\" font-size=\"13\" dominant-baseline=\"central\"><path d=\"M28 227l4 9h-8z\"/><path d=\"M380 243l4 9h-8z\"/><text x=\"16\" y=\"24\" textLength=\"48\">Safety</text><text x=\"72\" y=\"104\" textLength=\"40\">Ready</text><text x=\"120\" y=\"152\" textLength=\"40\">estop</text><text x=\"64\" y=\"200\" textLength=\"56\">Stopped</text><text x=\"160\" y=\"200\" textLength=\"32\">lamp</text><text x=\"160\" y=\"232\" textLength=\"104\">Production {}</text><text x=\"120\" y=\"280\" textLength=\"48\">!estop</text><text x=\"64\" y=\"328\" textLength=\"56\">Restart</text><text x=\"160\" y=\"328\" textLength=\"136\">Production {INIT}</text><text x=\"120\" y=\"376\" textLength=\"32\">true</text><text x=\"368\" y=\"24\" textLength=\"80\">Production</text><text x=\"420\" y=\"104\" textLength=\"32\">Idle</text><text x=\"464\" y=\"184\" textLength=\"40\">start</text><text x=\"624\" y=\"184\" textLength=\"112\">auto &amp;&amp; !start</text><text x=\"420\" y=\"248\" textLength=\"32\">Feed</text><text x=\"496\" y=\"248\" textLength=\"32\">belt</text><text x=\"580\" y=\"248\" textLength=\"32\">Auto</text><text x=\"672\" y=\"216\" textLength=\"56\">Clamp.X</text><text x=\"656\" y=\"248\" textLength=\"32\">bell</text><text x=\"464\" y=\"296\" textLength=\"32\">full</text><text x=\"624\" y=\"296\" textLength=\"120\">n &gt;= 2 &amp;&amp; !part</text><text x=\"624\" y=\"312\" textLength=\"64\">⇒ n := 0</text><text x=\"416\" y=\"360\" textLength=\"40\">Clamp</text><text x=\"464\" y=\"408\" textLength=\"64\">!clamped</text><text x=\"16\" y=\"488\" textLength=\"128\">macro step Clamp</text><text x=\"32\" y=\"536\" textLength=\"40\">Close</text><text x=\"112\" y=\"536\" textLength=\"8\">↑</text><text x=\"144\" y=\"536\" textLength=\"80\">clamp := 1</text><text x=\"80\" y=\"584\" textLength=\"56\">clamped</text><text x=\"36\" y=\"632\" textLength=\"32\">Open</text><text x=\"112\" y=\"632\" textLength=\"8\">↑</text><text x=\"144\" y=\"632\" textLength=\"80\">clamp := 0</text><text x=\"296\" y=\"520\" textLength=\"120\">Auto ▸ Counting</text><text x=\"328\" y=\"584\" textLength=\"40\">Count</text><text x=\"296\" y=\"584\" textLength=\"8\">*</text><text x=\"424\" y=\"552\" textLength=\"96\">rising(part)</text><text x=\"408\" y=\"584\" textLength=\"8\">→</text><text x=\"440\" y=\"584\" textLength=\"80\">n := n + 1</text></g></svg></div>\n"
)]
/**

The situation takes one byte: in which of 7 ways its 9 steps are active.*/
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct Cell {
    region_0: __CellRegion0,
    clamp: ::grafcet::__private::core::primitive::bool,
    n: ::grafcet::__private::core::primitive::u16,
    edge0_before: ::grafcet::__private::bool,
    stable: ::grafcet::__private::bool,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for Cell {}
impl Cell {
    ///A chart `Cell` in its initial situation; its activation belongs to the first cycle.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            region_0: __CellRegion0::Idle,
            clamp: false,
            n: 0,
            edge0_before: true,
            stable: true,
        }
    }
}
impl ::grafcet::__private::core::default::Default for Cell {
    fn default() -> Self {
        Self::new()
    }
}
///The process inputs of [`Cell`], sampled once per cycle.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::default::Default
)]
pub struct CellInputs {
    ///Input `estop`.
    pub estop: ::grafcet::__private::core::primitive::bool,
    ///Input `start`.
    pub start: ::grafcet::__private::core::primitive::bool,
    ///Input `part`.
    pub part: ::grafcet::__private::core::primitive::bool,
    ///Input `full`.
    pub full: ::grafcet::__private::core::primitive::bool,
    ///Input `clamped`.
    pub clamped: ::grafcet::__private::core::primitive::bool,
    ///Input `auto`.
    pub auto: ::grafcet::__private::core::primitive::bool,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for CellInputs {}
impl CellInputs {
    /// The default inputs, for constants and statics.
    pub const DEFAULT: Self = Self {
        estop: false,
        start: false,
        part: false,
        full: false,
        clamped: false,
        auto: false,
    };
}
///The process outputs of [`Cell`]; `default()` holds the initial values.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::default::Default
)]
pub struct CellOutputs {
    ///Output `belt`.
    pub belt: ::grafcet::__private::core::primitive::bool,
    ///Output `clamp`.
    pub clamp: ::grafcet::__private::core::primitive::bool,
    ///Output `lamp`.
    pub lamp: ::grafcet::__private::core::primitive::bool,
    ///Output `bell`.
    pub bell: ::grafcet::__private::core::primitive::bool,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for CellOutputs {}
///The names of the steps of [`Cell`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash
)]
pub enum CellStep {
    ///Step `Ready`.
    Ready,
    ///Step `Stopped`.
    Stopped,
    ///Step `Restart`.
    Restart,
    ///Step `Idle`.
    Idle,
    ///Step `Feed`.
    Feed,
    ///Step `Close`.
    Close,
    ///Step `Open`.
    Open,
    ///Step `Auto`.
    Auto,
    ///Step `Count`.
    Count,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for CellStep {}
impl CellStep {
    /// The name as it is written.
    #[must_use]
    pub const fn name(self) -> &'static ::grafcet::__private::str {
        ::grafcet::__private::name_at(
            &[
                "Ready",
                "Stopped",
                "Restart",
                "Idle",
                "Feed",
                "Close",
                "Open",
                "Auto",
                "Count",
            ],
            self as ::grafcet::__private::usize,
        )
    }
}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for CellStep {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str((*self).name())
    }
}
impl ::grafcet::__private::core::fmt::Display for CellStep {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.pad((*self).name())
    }
}
///The names of the transitions of [`Cell`].
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq,
    ::grafcet::__private::core::cmp::PartialOrd,
    ::grafcet::__private::core::cmp::Ord,
    ::grafcet::__private::core::hash::Hash
)]
pub enum CellTransition {
    ///`Ready -[estop]-> Stopped`
    ReadyToStopped,
    ///`Stopped -[!estop]-> Restart`
    StoppedToRestart,
    ///`Restart -[true]-> Ready`
    RestartToReady,
    ///`Close -[clamped]-> Open`
    CloseToOpen,
    ///`Idle -[start]-> Feed`
    IdleToFeed,
    ///`Feed -[full]-> Close`
    FeedToClose,
    ///`Open -[!clamped]-> Idle`
    OpenToIdle,
    ///`Idle -[auto && !start]-> Auto`
    IdleToAuto,
    ///`Auto -[n >= 2 && !part]-> Idle`
    AutoToIdle,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for CellTransition {}
impl CellTransition {
    /// The name as it is written.
    #[must_use]
    pub const fn name(self) -> &'static ::grafcet::__private::str {
        ::grafcet::__private::name_at(
            &[
                "ReadyToStopped",
                "StoppedToRestart",
                "RestartToReady",
                "CloseToOpen",
                "IdleToFeed",
                "FeedToClose",
                "OpenToIdle",
                "IdleToAuto",
                "AutoToIdle",
            ],
            self as ::grafcet::__private::usize,
        )
    }
}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for CellTransition {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str((*self).name())
    }
}
impl ::grafcet::__private::core::fmt::Display for CellTransition {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.pad((*self).name())
    }
}
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq
)]
#[doc(hidden)]
enum __CellRegion0 {
    Stopped,
    Restart,
    Idle,
    Feed,
    Close,
    Open,
    Count,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for __CellRegion0 {}
#[automatically_derived]
impl ::grafcet::__private::core::fmt::Debug for __CellRegion0 {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        f_.write_str(
            ::grafcet::__private::name_at(
                &["Stopped", "Restart", "Idle", "Feed", "Close", "Open", "Count"],
                *self as ::grafcet::__private::usize,
            ),
        )
    }
}
///A situation of [`Cell`]: which steps are active.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct CellSituation {
    region_0: __CellRegion0,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for CellSituation {}
impl CellSituation {
    /// Whether the step is active in this situation.
    #[must_use]
    pub fn is_active(
        &self,
        #[cfg(not(doc))]
        step_: CellStep,
        #[cfg(doc)]
        step: CellStep,
    ) -> ::grafcet::__private::bool {
        match step_ {
            CellStep::Ready => {
                ::grafcet::__private::core::matches!(
                    self.region_0, __CellRegion0::Idle | __CellRegion0::Feed |
                    __CellRegion0::Close | __CellRegion0::Open | __CellRegion0::Count
                )
            }
            CellStep::Stopped => self.region_0 == __CellRegion0::Stopped,
            CellStep::Restart => self.region_0 == __CellRegion0::Restart,
            CellStep::Idle => {
                ::grafcet::__private::core::matches!(
                    self.region_0, __CellRegion0::Restart | __CellRegion0::Idle
                )
            }
            CellStep::Feed => self.region_0 == __CellRegion0::Feed,
            CellStep::Close => self.region_0 == __CellRegion0::Close,
            CellStep::Open => self.region_0 == __CellRegion0::Open,
            CellStep::Auto => self.region_0 == __CellRegion0::Count,
            CellStep::Count => self.region_0 == __CellRegion0::Count,
        }
    }
}
impl ::grafcet::__private::core::fmt::Debug for CellSituation {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        let mut set_ = f_.debug_set();
        for step_ in <Cell as ::grafcet::__private::Chart>::STEPS {
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
impl ::grafcet::__private::core::fmt::Display for CellSituation {
    fn fmt(
        &self,
        f_: &mut ::grafcet::__private::core::fmt::Formatter<'_>,
    ) -> ::grafcet::__private::core::fmt::Result {
        let names_ = ::grafcet::__private::core::iter::Iterator::map(
            <Cell as ::grafcet::__private::Chart>::STEPS.iter(),
            |step_| (*step_).name(),
        );
        ::grafcet::__private::situation::write(self, names_, f_)
    }
}
impl Cell {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    pub fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &CellInputs,
        #[cfg(doc)]
        inputs: &CellInputs,
    ) -> CellOutputs {
        let mut outputs_ = const {
            CellOutputs {
                belt: false,
                clamp: false,
                lamp: false,
                bell: false,
            }
        };
        let inputs_ = ::grafcet::__private::core::hint::black_box(inputs_);
        let mut clears_auto_idle_: ::grafcet::__private::bool = false;
        let mut evolutions_: ::grafcet::__private::u32 = 0;
        loop {
            ::grafcet::__private::fence_on_armv6m();
            let mut moves_32__: ::grafcet::__private::bool = false;
            let was_state_count_: __CellRegion0 = self.region_0;
            let mut next_clamp_: ::grafcet::__private::bool = self.clamp;
            let mut next_n_: ::grafcet::__private::core::primitive::u16 = self.n;
            match self.region_0 {
                __CellRegion0::Stopped => {
                    if !inputs_.estop {
                        moves_32__ = true;
                        self.region_0 = __CellRegion0::Restart;
                        clears_auto_idle_ = false;
                    } else {
                        clears_auto_idle_ = false;
                    }
                }
                __CellRegion0::Restart => {
                    self.region_0 = __CellRegion0::Idle;
                    moves_32__ = true;
                    clears_auto_idle_ = false;
                }
                _ => {
                    if inputs_.estop {
                        moves_32__ = true;
                        clears_auto_idle_ = false;
                        self.region_0 = __CellRegion0::Stopped;
                        if was_state_count_ == __CellRegion0::Count && !self.edge0_before
                            && inputs_.part
                        {
                            next_n_ = {
                                let n = self.n;
                                n + 1
                            };
                        }
                    } else {
                        ::grafcet::__private::fence_on_armv6m();
                        match self.region_0 {
                            __CellRegion0::Idle => {
                                if inputs_.start {
                                    self.region_0 = __CellRegion0::Feed;
                                    clears_auto_idle_ = false;
                                    moves_32__ = true;
                                } else {
                                    if inputs_.auto {
                                        clears_auto_idle_ = false;
                                        moves_32__ = true;
                                        self.region_0 = __CellRegion0::Count;
                                    } else {
                                        clears_auto_idle_ = false;
                                    }
                                }
                            }
                            __CellRegion0::Feed => {
                                if inputs_.full {
                                    self.region_0 = __CellRegion0::Close;
                                    clears_auto_idle_ = false;
                                    next_clamp_ = true;
                                    moves_32__ = true;
                                } else {
                                    clears_auto_idle_ = false;
                                }
                            }
                            __CellRegion0::Close => {
                                if inputs_.clamped {
                                    self.region_0 = __CellRegion0::Open;
                                    clears_auto_idle_ = false;
                                    next_clamp_ = false;
                                    moves_32__ = true;
                                } else {
                                    clears_auto_idle_ = false;
                                }
                            }
                            __CellRegion0::Open => {
                                if !inputs_.clamped {
                                    self.region_0 = __CellRegion0::Idle;
                                    clears_auto_idle_ = false;
                                    moves_32__ = true;
                                } else {
                                    clears_auto_idle_ = false;
                                }
                            }
                            __CellRegion0::Count => {
                                if inputs_.part {
                                    clears_auto_idle_ = false;
                                    if !self.edge0_before {
                                        next_n_ = {
                                            let n = self.n;
                                            n + 1
                                        };
                                    }
                                } else {
                                    if {
                                        let n = self.n;
                                        n >= 2
                                    } {
                                        clears_auto_idle_ = true;
                                        moves_32__ = true;
                                        self.region_0 = __CellRegion0::Idle;
                                    } else {
                                        clears_auto_idle_ = false;
                                    }
                                }
                            }
                            _ => {}
                        }
                    }
                }
            }
            if clears_auto_idle_ {
                next_n_ = 0;
            }
            moves_32__ = moves_32__ || self.n != next_n_;
            if !moves_32__ {
                self.stable = true;
                break;
            }
            if evolutions_ == 20 {
                self.stable = false;
                self.region_0 = was_state_count_;
                break;
            }
            self.clamp = next_clamp_;
            self.n = next_n_;
            self.edge0_before = inputs_.part;
            evolutions_ = evolutions_.wrapping_add(1);
        }
        ::grafcet::__private::core::sync::atomic::compiler_fence(
            ::grafcet::__private::core::sync::atomic::Ordering::SeqCst,
        );
        if self.stable {
            self.edge0_before = inputs_.part;
        }
        match self.region_0 {
            __CellRegion0::Stopped => {
                outputs_.lamp = true;
            }
            __CellRegion0::Feed => {
                outputs_.belt = true;
            }
            _ => {}
        }
        outputs_.clamp = self.clamp;
        outputs_
    }
    /// Back to the initial situation (the classic *Init*), stored outputs and variables reset; the next cycle is a
    /// first one.
    pub fn init(&mut self) {
        *self = Self::new();
    }
    /// Whether the step is active.
    #[must_use]
    pub fn is_active(
        &self,
        #[cfg(not(doc))]
        step_: CellStep,
        #[cfg(doc)]
        step: CellStep,
    ) -> ::grafcet::__private::bool {
        match step_ {
            CellStep::Ready => {
                ::grafcet::__private::core::matches!(
                    self.region_0, __CellRegion0::Idle | __CellRegion0::Feed |
                    __CellRegion0::Close | __CellRegion0::Open | __CellRegion0::Count
                )
            }
            CellStep::Stopped => self.region_0 == __CellRegion0::Stopped,
            CellStep::Restart => self.region_0 == __CellRegion0::Restart,
            CellStep::Idle => {
                ::grafcet::__private::core::matches!(
                    self.region_0, __CellRegion0::Restart | __CellRegion0::Idle
                )
            }
            CellStep::Feed => self.region_0 == __CellRegion0::Feed,
            CellStep::Close => self.region_0 == __CellRegion0::Close,
            CellStep::Open => self.region_0 == __CellRegion0::Open,
            CellStep::Auto => self.region_0 == __CellRegion0::Count,
            CellStep::Count => self.region_0 == __CellRegion0::Count,
        }
    }
    /// The active steps, in the order of their declaration; the capacity is the most that can be active.
    #[must_use]
    pub fn active_steps(&self) -> ::grafcet::__private::heapless::Vec<CellStep, 3> {
        let mut steps_ = ::grafcet::__private::heapless::Vec::new();
        if ::grafcet::__private::core::matches!(
            self.region_0, __CellRegion0::Idle | __CellRegion0::Feed |
            __CellRegion0::Close | __CellRegion0::Open | __CellRegion0::Count
        ) {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                CellStep::Ready,
            );
        }
        if self.region_0 == __CellRegion0::Stopped {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                CellStep::Stopped,
            );
        }
        if self.region_0 == __CellRegion0::Restart {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                CellStep::Restart,
            );
        }
        if ::grafcet::__private::core::matches!(
            self.region_0, __CellRegion0::Restart | __CellRegion0::Idle
        ) {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                CellStep::Idle,
            );
        }
        if self.region_0 == __CellRegion0::Feed {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                CellStep::Feed,
            );
        }
        if self.region_0 == __CellRegion0::Close {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                CellStep::Close,
            );
        }
        if self.region_0 == __CellRegion0::Open {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                CellStep::Open,
            );
        }
        if self.region_0 == __CellRegion0::Count {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                CellStep::Auto,
            );
        }
        if self.region_0 == __CellRegion0::Count {
            let _ = ::grafcet::__private::heapless::Vec::push(
                &mut steps_,
                CellStep::Count,
            );
        }
        steps_
    }
    /// The situation: which steps are active.
    #[must_use]
    pub const fn situation(&self) -> CellSituation {
        CellSituation {
            region_0: self.region_0,
        }
    }
    /// Whether these steps are active, in any order, and no others: the same question for one active step and
    /// for several.
    #[must_use]
    pub fn is_exactly(
        &self,
        #[cfg(not(doc))]
        steps_: &[CellStep],
        #[cfg(doc)]
        steps: &[CellStep],
    ) -> ::grafcet::__private::bool {
        ::grafcet::__private::Chart::is_exactly(self, steps_)
    }
    /// Whether the last cycle reached a stable situation. If not, it stopped after the most evolutions it may make
    /// and keeps the situation it had reached (decision A30).
    #[must_use]
    pub const fn is_stable(&self) -> ::grafcet::__private::bool {
        self.stable
    }
}
///The variables of [`Cell`], as the last cycle has left them.
#[derive(
    ::grafcet::__private::core::clone::Clone,
    ::grafcet::__private::core::marker::Copy,
    ::grafcet::__private::core::fmt::Debug,
    ::grafcet::__private::core::cmp::PartialEq
)]
pub struct CellVars {
    ///Variable `n`.
    pub n: ::grafcet::__private::core::primitive::u16,
}
#[automatically_derived]
impl ::grafcet::__private::core::cmp::Eq for CellVars {}
impl Cell {
    /// The variables, as the last cycle has left them.
    #[must_use]
    pub fn vars(&self) -> CellVars {
        CellVars { n: self.n }
    }
}
impl ::grafcet::__private::Chart for Cell {
    type Inputs = CellInputs;
    type Outputs = CellOutputs;
    type Step = CellStep;
    type Transition = CellTransition;
    type Situation = CellSituation;
    type Actions<'a> = ();
    const NAME: &'static ::grafcet::__private::str = "Cell";
    const STEPS: &'static [CellStep] = &[
        CellStep::Ready,
        CellStep::Stopped,
        CellStep::Restart,
        CellStep::Idle,
        CellStep::Feed,
        CellStep::Close,
        CellStep::Open,
        CellStep::Auto,
        CellStep::Count,
    ];
    const TRANSITIONS: &'static [CellTransition] = &[
        CellTransition::ReadyToStopped,
        CellTransition::StoppedToRestart,
        CellTransition::RestartToReady,
        CellTransition::CloseToOpen,
        CellTransition::IdleToFeed,
        CellTransition::FeedToClose,
        CellTransition::OpenToIdle,
        CellTransition::IdleToAuto,
        CellTransition::AutoToIdle,
    ];
    fn scan(
        &mut self,
        inputs_: &CellInputs,
        _: ::grafcet::__private::Ticks,
        _: &mut Self::Actions<'_>,
    ) -> CellOutputs {
        self.cycle(inputs_)
    }
    fn init(&mut self) {
        self.init();
    }
    fn is_active(&self, step_: CellStep) -> ::grafcet::__private::bool {
        self.is_active(step_)
    }
    fn situation(&self) -> CellSituation {
        self.situation()
    }
}
impl Cell {
    /// What the chart looks like: its steps, transitions and actions as they stand in the source.
    pub const CHART: ::grafcet::__private::description::Description<'static> = ::grafcet::__private::description::table::Described::<
        Cell,
        6,
        3,
        18,
        4,
        1,
        9,
        9,
        0,
    >::grafcet();
}
impl ::grafcet::__private::description::table::Tables for Cell {
    const TEXTS: &'static [&'static ::grafcet::__private::str] = &[
        "",
        "!clamped",
        "!estop",
        "Auto",
        "Cell",
        "Clamp",
        "Clamp.X",
        "Close",
        "Count",
        "Counting",
        "Feed",
        "Idle",
        "N",
        "Open",
        "Production",
        "Production {INIT}",
        "Production {}",
        "R",
        "Ready",
        "Restart",
        "S",
        "Safety",
        "Stopped",
        "auto && !start",
        "bell",
        "belt",
        "clamp",
        "clamped",
        "estop",
        "full",
        "lamp",
        "n = 0",
        "n = n + 1",
        "n >= 2 && !part",
        "on",
        "rising(part)",
        "start",
        "true",
    ];
    const NUMBERS: &'static [::grafcet::__private::u8] = b"\x0C\0\0\x1E\x0C\0\0\x19\x14\0\0\x1A\x11\0\0\x1A\x0C\0\x06\x18\"\0# \x10\x0F\x1F\0\x01\x01\x02\x02\0\x05\x06\x03\x04\x04\x05\x06\x03\x03\x07\x07\x03\x04\0\0\0\x15\0\0\x0E\0\0\t\x08\0\x05\0\x05\x06\0\x12\x01\x01\0\0\0\0\x16\0\x01\0\x01\0\x01\x13\0\x01\0\0\0\x01\x0B\x01\x02\0\0\0\0\n\0\x02\0\x01\0\0\x07\0\x02\x01\x01\0\0\r\0\x02\x01\x01\0\0\x03\0\x02\0\x01\0\0\x08\x02\x03\0\x01\0\0\0\x1C\x01\x01\0\0\0\x02\x01\x01\0\0\0%\x01\x01\0\0\0\x1B\x01\x01\0\0\0$\x01\x01\0\0\0\x1D\x01\x01\0\0\0\x01\x01\x01\0\0\0\x17\x01\x01\0\0\0!\x01\x01\x01\0";
}
impl ::grafcet::__private::ActiveSteps for CellSituation {
    fn is_active_at(
        &self,
        step_: ::grafcet::__private::usize,
    ) -> ::grafcet::__private::bool {
        match ::grafcet::__private::step_at::<Cell>(step_) {
            ::grafcet::__private::Option::Some(active_) => self.is_active(active_),
            ::grafcet::__private::Option::None => false,
        }
    }
}
#[allow(unexpected_cfgs)]
const _: () = {
    #[cfg(rust_analyzer)]
    fn mentions(inputs_: &CellInputs, outputs_: &CellOutputs) {
        let _ = [
            CellStep::Ready,
            CellStep::Stopped,
            CellStep::Restart,
            CellStep::Ready,
            CellStep::Close,
            CellStep::Open,
            CellStep::Idle,
            CellStep::Feed,
            CellStep::Idle,
            CellStep::Idle,
            CellStep::Auto,
            CellStep::Idle,
        ];
        let _ = (
            &inputs_.estop,
            &inputs_.estop,
            &inputs_.clamped,
            &inputs_.part,
            &inputs_.start,
            &inputs_.full,
            &inputs_.clamped,
            &inputs_.auto,
            &inputs_.start,
            &inputs_.part,
        );
        let _ = (
            &outputs_.lamp,
            &outputs_.belt,
            &outputs_.clamp,
            &outputs_.clamp,
            &outputs_.bell,
        );
        {
            enum MacroStep {
                Clamp,
            }
            let _ = [MacroStep::Clamp, MacroStep::Clamp];
        }
        {
            enum Partial {
                Safety,
                Production,
                Counting,
            }
            let _ = [Partial::Production, Partial::Production];
        }
        {
            struct Variables {
                n: ::grafcet::__private::core::primitive::u16,
            }
            fn mentions(variables_: &Variables) {
                let _ = (&variables_.n, &variables_.n, &variables_.n, &variables_.n);
            }
        }
    }
};
