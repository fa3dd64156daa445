use grafcet::grafcet;

// Parallel branches that are left together, from wherever they are.
grafcet! {
    sfc AbortAll {
        input start, a, b, abort: bool; output x, y, alarm: bool;
        initial step I; step A1 { x; } step A2; step B1 { y; } step B2; step Alarm { alarm; }
        I -[start]-> (A1, B1);
        (A1, B1) -[abort]-> Alarm; (A2, B1) -[abort]-> Alarm; (A1, B2) -[abort]-> Alarm;
        A1 -[a]-> A2; B1 -[b]-> B2;
        (A2, B2) -[true]-> I;
        Alarm -[!abort && !start]-> I;
    }
}
