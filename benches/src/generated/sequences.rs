//! Rings of 4, 16 and 64 steps. Which sensor ends a step and which valves are open in it follows no rule, as in a plant.

use super::both;

both! { seq4 {
    input x0, x1, x2, x3: bool;
    output q0, q1, q2, q3: bool;

    initial step S0 { q1; }
    step S1 { q2; }
    step S2 { q0; }
    step S3 { q3; }

    S0 -[x2]-> S1 -[x0]-> S2 -[x3]-> S3 -[!x1]-> S0;
} }

both! { seq16 {
    input x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15: bool;
    output q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15: bool;

    initial step S0 { q7; }
    step S1 { q10; }
    step S2 { q7; q9; }
    step S3 { q4; }
    step S4 { q13; }
    step S5 { q0; }
    step S6 { q3; q6; }
    step S7 { q14; }
    step S8 { q1; }
    step S9 { q2; }
    step S10 { q12; }
    step S11 { q5; }
    step S12 { q8; }
    step S13 { q6; }
    step S14 { q15; }
    step S15 { q7; q11; }

    S0 -[x3]-> S1 -[x0]-> S2 -[x11]-> S3 -[x10]-> S4 -[x13]-> S5 -[x6]-> S6 -[x12]-> S7 -[x8]-> S8;
    S8 -[!x15]-> S9 -[!x4]-> S10 -[x14]-> S11 -[x1]-> S12 -[x2]-> S13 -[x7]-> S14 -[x9]-> S15 -[x5]-> S0;
} }

both! { seq64, seq64_size {
    input x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15: bool;
    output q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15: bool;

    initial step S0 { q4; q9; }
    step S1 { q8; }
    step S2 { q1; }
    step S3 { q9; q15; }
    step S4 { q0; q6; }
    step S5 { q9; }
    step S6 { q6; }
    step S7 { q9; q15; }
    step S8 { q12; q15; }
    step S9 { q3; q15; }
    step S10 { q7; }
    step S11 { q3; q4; }
    step S12 { q11; }
    step S13 { q6; }
    step S14 { q0; }
    step S15 { q6; }
    step S16 { q11; }
    step S17 { q1; q5; }
    step S18 { q13; }
    step S19 { q14; }
    step S20 { q1; }
    step S21 { q10; }
    step S22 { q8; q14; }
    step S23 { q2; q9; }
    step S24 { q14; }
    step S25 { q5; }
    step S26 { q0; }
    step S27 { q13; }
    step S28 { q0; q12; }
    step S29 { q11; q15; }
    step S30 { q5; }
    step S31 { q0; q8; }
    step S32 { q10; }
    step S33 { q1; q14; }
    step S34 { q11; }
    step S35 { q4; q13; }
    step S36 { q1; q11; }
    step S37 { q2; }
    step S38 { q6; }
    step S39 { q1; q5; }
    step S40 { q3; }
    step S41 { q9; q10; }
    step S42 { q2; }
    step S43 { q10; }
    step S44 { q2; }
    step S45 { q8; }
    step S46 { q10; }
    step S47 { q4; }
    step S48 { q13; q14; }
    step S49 { q1; q12; }
    step S50 { q0; }
    step S51 { q2; }
    step S52 { q1; q12; }
    step S53 { q4; }
    step S54 { q7; q9; }
    step S55 { q8; }
    step S56 { q5; }
    step S57 { q14; }
    step S58 { q13; }
    step S59 { q3; q11; }
    step S60 { q7; }
    step S61 { q3; }
    step S62 { q7; }
    step S63 { q7; q15; }

    S0 -[x7]-> S1 -[!x4]-> S2 -[x5]-> S3 -[!x1]-> S4 -[x0]-> S5 -[x15]-> S6 -[!x2]-> S7 -[x0]-> S8;
    S8 -[!x11]-> S9 -[x6]-> S10 -[!x13]-> S11 -[x14]-> S12 -[x12]-> S13 -[x6]-> S14 -[x0]-> S15 -[!x10]-> S16;
    S16 -[x15]-> S17 -[x7]-> S18 -[x14]-> S19 -[x4]-> S20 -[!x1]-> S21 -[x5]-> S22 -[!x8]-> S23 -[!x10]-> S24;
    S24 -[x11]-> S25 -[x9]-> S26 -[x8]-> S27 -[x13]-> S28 -[!x4]-> S29 -[!x12]-> S30 -[x8]-> S31 -[x7]-> S32;
    S32 -[x1]-> S33 -[x3]-> S34 -[!x13]-> S35 -[x3]-> S36 -[!x6]-> S37 -[x10]-> S38 -[x12]-> S39 -[x9]-> S40;
    S40 -[x7]-> S41 -[x10]-> S42 -[!x15]-> S43 -[!x1]-> S44 -[!x5]-> S45 -[!x9]-> S46 -[x12]-> S47 -[!x11]-> S48;
    S48 -[!x14]-> S49 -[!x0]-> S50 -[x11]-> S51 -[x15]-> S52 -[!x2]-> S53 -[x8]-> S54 -[!x3]-> S55 -[x9]-> S56;
    S56 -[x4]-> S57 -[x2]-> S58 -[!x6]-> S59 -[x5]-> S60 -[!x3]-> S61 -[!x2]-> S62 -[x14]-> S63 -[!x13]-> S0;
} }
