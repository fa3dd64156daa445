// Imported from blocks.st by cargo grafcet.
//
// Renamed in Blocks:
//   Latch.Q1 is latch_q1
//   Hold.Q1 is hold_q1
//   Parts.Q is parts_q
//   Parts.CV is parts_cv
//   Parts.CU_before is parts_cu_before
//   Levels.QD is levels_qd
//   Levels.CV is levels_cv
//   Levels.CU_before is levels_cu_before
//   Levels.CD_before is levels_cd_before
//   Down.Q is down_q
//   Down.CV is down_cv
//   Down.CD_before is down_cd_before
//   Edge.Q is edge_q
//   Edge.CLK_before is edge_clk_before
//
// To be looked at in Blocks:
//   `Soak` is called in some steps alone: here its time begins with them
//   `Waits` goes on from `Wait` to `Rest` in the file, and here has its final call in one and a first one in the other, in one cycle
//   `Waits` goes on from `Wait` to `Rest` in the file, and here has its final call in one and a first one in the other, in one cycle

use grafcet::grafcet;

grafcet! {
    /// Standard function blocks, as they are called in each scan, or in some steps alone.
    pub sfc Blocks {
        input part, stop, go: bool;
        param t: time = 3s;
        output q, full, fell, tail, empty, done: bool;
        output count, level: i16;
        var latch_q1, hold_q1, parts_q: bool;
        var parts_cv: i16;
        var parts_cu_before, levels_qd: bool;
        var levels_cv: i16;
        var levels_cu_before, levels_cd_before, down_q: bool;
        var down_cv: i16;
        var down_cd_before, edge_q, edge_clk_before: bool;

        initial step Run {
            // one instance, called twice
            N {
                latch_q1 = part || !stop && latch_q1;
                hold_q1 = !stop && (part || hold_q1);
                q = hold_q1;
                if stop {
                    parts_cv = 0;
                } else if part && !parts_cu_before {
                    parts_cv = parts_cv.saturating_add(1);
                }
                parts_cu_before = part;
                parts_q = parts_cv >= 2;
                full = parts_q;
                count = parts_cv;
                if stop {
                    levels_cv = 3;
                } else if part && !levels_cu_before && !(go && !levels_cd_before) {
                    levels_cv = levels_cv.saturating_add(1);
                } else if go && !levels_cd_before && !(part && !levels_cu_before) {
                    levels_cv = levels_cv.saturating_sub(1);
                }
                levels_cu_before = part;
                levels_cd_before = go;
                levels_qd = levels_cv <= 0;
                level = levels_cv;
                empty = levels_qd;
                if stop {
                    down_cv = 1;
                } else if part && !down_cd_before {
                    down_cv = down_cv.saturating_sub(1);
                }
                down_cd_before = part;
                down_q = down_cv <= 0;
                if down_q {
                    empty = true;
                }
                edge_q = !part && edge_clk_before;
                edge_clk_before = part;
                fell = edge_q;
                edge_q = !stop && edge_clk_before;
                edge_clk_before = stop;
                tail = 0s/part/1s;
            }
        }
        step Wait {
            N { done = t/Wait; }
        }
        step Rest {
            N { done = t/Rest; }
        }

        Run -[go && latch_q1]-> Wait -[t/Wait]-> Rest -[t/Rest && !done]-> Run;
    }
}
