// The ring of 64 steps.

#include "chart.h"

typedef struct {
    bool x0, x1, x2, x3, x4, x5, x6, x7, x8, x9, x10, x11, x12, x13, x14, x15;
} inputs_t;

typedef struct {
    bool q0, q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12, q13, q14, q15;
} outputs_t;

enum {
    S0, S1, S2, S3, S4, S5, S6, S7,
    S8, S9, S10, S11, S12, S13, S14, S15,
    S16, S17, S18, S19, S20, S21, S22, S23,
    S24, S25, S26, S27, S28, S29, S30, S31,
    S32, S33, S34, S35, S36, S37, S38, S39,
    S40, S41, S42, S43, S44, S45, S46, S47,
    S48, S49, S50, S51, S52, S53, S54, S55,
    S56, S57, S58, S59, S60, S61, S62, S63,
    INIT,
};

static inline uint8_t next(uint8_t step, const inputs_t *i) {
    switch (step) {
    case S0: if (i->x7) return S1; break;
    case S1: if (!i->x4) return S2; break;
    case S2: if (i->x5) return S3; break;
    case S3: if (!i->x1) return S4; break;
    case S4: if (i->x0) return S5; break;
    case S5: if (i->x15) return S6; break;
    case S6: if (!i->x2) return S7; break;
    case S7: if (i->x0) return S8; break;
    case S8: if (!i->x11) return S9; break;
    case S9: if (i->x6) return S10; break;
    case S10: if (!i->x13) return S11; break;
    case S11: if (i->x14) return S12; break;
    case S12: if (i->x12) return S13; break;
    case S13: if (i->x6) return S14; break;
    case S14: if (i->x0) return S15; break;
    case S15: if (!i->x10) return S16; break;
    case S16: if (i->x15) return S17; break;
    case S17: if (i->x7) return S18; break;
    case S18: if (i->x14) return S19; break;
    case S19: if (i->x4) return S20; break;
    case S20: if (!i->x1) return S21; break;
    case S21: if (i->x5) return S22; break;
    case S22: if (!i->x8) return S23; break;
    case S23: if (!i->x10) return S24; break;
    case S24: if (i->x11) return S25; break;
    case S25: if (i->x9) return S26; break;
    case S26: if (i->x8) return S27; break;
    case S27: if (i->x13) return S28; break;
    case S28: if (!i->x4) return S29; break;
    case S29: if (!i->x12) return S30; break;
    case S30: if (i->x8) return S31; break;
    case S31: if (i->x7) return S32; break;
    case S32: if (i->x1) return S33; break;
    case S33: if (i->x3) return S34; break;
    case S34: if (!i->x13) return S35; break;
    case S35: if (i->x3) return S36; break;
    case S36: if (!i->x6) return S37; break;
    case S37: if (i->x10) return S38; break;
    case S38: if (i->x12) return S39; break;
    case S39: if (i->x9) return S40; break;
    case S40: if (i->x7) return S41; break;
    case S41: if (i->x10) return S42; break;
    case S42: if (!i->x15) return S43; break;
    case S43: if (!i->x1) return S44; break;
    case S44: if (!i->x5) return S45; break;
    case S45: if (!i->x9) return S46; break;
    case S46: if (i->x12) return S47; break;
    case S47: if (!i->x11) return S48; break;
    case S48: if (!i->x14) return S49; break;
    case S49: if (!i->x0) return S50; break;
    case S50: if (i->x11) return S51; break;
    case S51: if (i->x15) return S52; break;
    case S52: if (!i->x2) return S53; break;
    case S53: if (i->x8) return S54; break;
    case S54: if (!i->x3) return S55; break;
    case S55: if (i->x9) return S56; break;
    case S56: if (i->x4) return S57; break;
    case S57: if (i->x2) return S58; break;
    case S58: if (!i->x6) return S59; break;
    case S59: if (i->x5) return S60; break;
    case S60: if (!i->x3) return S61; break;
    case S61: if (!i->x2) return S62; break;
    case S62: if (i->x14) return S63; break;
    case S63: if (!i->x13) return S0; break;
    }
    return step;
}

static inline void act(uint8_t step, outputs_t *q) {
    q->q0 = q->q1 = q->q2 = q->q3 = q->q4 = q->q5 = q->q6 = q->q7 = false;
    q->q8 = q->q9 = q->q10 = q->q11 = q->q12 = q->q13 = q->q14 = q->q15 = false;
    switch (step) {
    case S14: case S26: case S50: q->q0 = true; break;
    case S4: q->q0 = q->q6 = true; break;
    case S31: q->q0 = q->q8 = true; break;
    case S28: q->q0 = q->q12 = true; break;
    case S2: case S20: q->q1 = true; break;
    case S17: case S39: q->q1 = q->q5 = true; break;
    case S36: q->q1 = q->q11 = true; break;
    case S49: case S52: q->q1 = q->q12 = true; break;
    case S33: q->q1 = q->q14 = true; break;
    case S37: case S42: case S44: case S51: q->q2 = true; break;
    case S23: q->q2 = q->q9 = true; break;
    case S40: case S61: q->q3 = true; break;
    case S11: q->q3 = q->q4 = true; break;
    case S59: q->q3 = q->q11 = true; break;
    case S9: q->q3 = q->q15 = true; break;
    case S47: case S53: q->q4 = true; break;
    case S0: q->q4 = q->q9 = true; break;
    case S35: q->q4 = q->q13 = true; break;
    case S25: case S30: case S56: q->q5 = true; break;
    case S6: case S13: case S15: case S38: q->q6 = true; break;
    case S10: case S60: case S62: q->q7 = true; break;
    case S54: q->q7 = q->q9 = true; break;
    case S63: q->q7 = q->q15 = true; break;
    case S1: case S45: case S55: q->q8 = true; break;
    case S22: q->q8 = q->q14 = true; break;
    case S5: q->q9 = true; break;
    case S41: q->q9 = q->q10 = true; break;
    case S3: case S7: q->q9 = q->q15 = true; break;
    case S21: case S32: case S43: case S46: q->q10 = true; break;
    case S12: case S16: case S34: q->q11 = true; break;
    case S29: q->q11 = q->q15 = true; break;
    case S8: q->q12 = q->q15 = true; break;
    case S18: case S27: case S58: q->q13 = true; break;
    case S48: q->q13 = q->q14 = true; break;
    case S19: case S24: case S57: q->q14 = true; break;
    }
}

typedef struct {
    uint8_t step;
} seq64_sfc_t;

// IEC 61131-3: one evolution per cycle, none in the first.
void seq64_sfc_cycle(seq64_sfc_t *c, const inputs_t *i, outputs_t *q) {
    c->step = c->step == INIT ? S0 : next(c->step, i);
    act(c->step, q);
}

typedef struct {
    uint8_t step;
    bool stable;
} seq64_grafcet_t;

// IEC 60848: evolutions until the step stays, at most twice the number of steps plus two.
void seq64_grafcet_cycle(seq64_grafcet_t *c, const inputs_t *i, outputs_t *q) {
    c->stable = true;
    for (uint8_t left = 130;; left--) {
        uint8_t step = next(c->step, i);
        if (step == c->step)
            break;
        if (left == 0) {
            c->stable = false;
            break;
        }
        c->step = step;
    }
    act(c->step, q);
}
