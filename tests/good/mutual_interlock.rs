use grafcet::grafcet;

// Two drives that must not run together, by step variables; of two commands at once the left one wins.
grafcet! {
    grafcet Interlock {
        input l_cmd, r_cmd, l_end, r_end: bool;
        output left, right: bool;
        partial Le { initial step LOff; step LOn { left; } LOff -[rising(l_cmd) && Ri::ROff.X]-> LOn -[l_end || falling(l_cmd)]-> LOff; }
        partial Ri { initial step ROff; step ROn { right; } ROff -[rising(r_cmd) && Le::LOff.X && !rising(l_cmd)]-> ROn -[r_end || falling(r_cmd)]-> ROff; }
    }
}
