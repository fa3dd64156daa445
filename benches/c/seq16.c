// The ring of 16 steps.

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
    INIT,
};

static inline uint8_t next(uint8_t step, const inputs_t *i) {
    switch (step) {
    case S0: if (i->x3) return S1; break;
    case S1: if (i->x0) return S2; break;
    case S2: if (i->x11) return S3; break;
    case S3: if (i->x10) return S4; break;
    case S4: if (i->x13) return S5; break;
    case S5: if (i->x6) return S6; break;
    case S6: if (i->x12) return S7; break;
    case S7: if (i->x8) return S8; break;
    case S8: if (!i->x15) return S9; break;
    case S9: if (!i->x4) return S10; break;
    case S10: if (i->x14) return S11; break;
    case S11: if (i->x1) return S12; break;
    case S12: if (i->x2) return S13; break;
    case S13: if (i->x7) return S14; break;
    case S14: if (i->x9) return S15; break;
    case S15: if (i->x5) return S0; break;
    }
    return step;
}

static inline void act(uint8_t step, outputs_t *q) {
    q->q0 = q->q1 = q->q2 = q->q3 = q->q4 = q->q5 = q->q6 = q->q7 = false;
    q->q8 = q->q9 = q->q10 = q->q11 = q->q12 = q->q13 = q->q14 = q->q15 = false;
    switch (step) {
    case S5: q->q0 = true; break;
    case S8: q->q1 = true; break;
    case S9: q->q2 = true; break;
    case S6: q->q3 = q->q6 = true; break;
    case S3: q->q4 = true; break;
    case S11: q->q5 = true; break;
    case S13: q->q6 = true; break;
    case S0: q->q7 = true; break;
    case S2: q->q7 = q->q9 = true; break;
    case S15: q->q7 = q->q11 = true; break;
    case S12: q->q8 = true; break;
    case S1: q->q10 = true; break;
    case S10: q->q12 = true; break;
    case S4: q->q13 = true; break;
    case S7: q->q14 = true; break;
    case S14: q->q15 = true; break;
    }
}

typedef struct {
    uint8_t step;
} seq16_sfc_t;

// IEC 61131-3: one evolution per cycle, none in the first.
void seq16_sfc_cycle(seq16_sfc_t *c, const inputs_t *i, outputs_t *q) {
    c->step = c->step == INIT ? S0 : next(c->step, i);
    act(c->step, q);
}

typedef struct {
    uint8_t step;
    bool stable;
} seq16_grafcet_t;

// IEC 60848: evolutions until the step stays, at most twice the number of steps plus two.
void seq16_grafcet_cycle(seq16_grafcet_t *c, const inputs_t *i, outputs_t *q) {
    c->stable = true;
    for (uint8_t left = 34;; left--) {
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
