// The ring of 4 steps.

#include "chart.h"

typedef struct {
    bool x0, x1, x2, x3;
} inputs_t;

typedef struct {
    bool q0, q1, q2, q3;
} outputs_t;

enum {
    S0, S1, S2, S3,
    INIT,
};

static inline uint8_t next(uint8_t step, const inputs_t *i) {
    switch (step) {
    case S0: if (i->x2) return S1; break;
    case S1: if (i->x0) return S2; break;
    case S2: if (i->x3) return S3; break;
    case S3: if (!i->x1) return S0; break;
    }
    return step;
}

static inline void act(uint8_t step, outputs_t *q) {
    q->q0 = q->q1 = q->q2 = q->q3 = false;
    switch (step) {
    case S2: q->q0 = true; break;
    case S0: q->q1 = true; break;
    case S1: q->q2 = true; break;
    case S3: q->q3 = true; break;
    }
}

typedef struct {
    uint8_t step;
} seq4_sfc_t;

// IEC 61131-3: one evolution per cycle, none in the first.
void seq4_sfc_cycle(seq4_sfc_t *c, const inputs_t *i, outputs_t *q) {
    c->step = c->step == INIT ? S0 : next(c->step, i);
    act(c->step, q);
}

typedef struct {
    uint8_t step;
    bool stable;
} seq4_grafcet_t;

// IEC 60848: evolutions until the step stays, at most twice the number of steps plus two.
void seq4_grafcet_cycle(seq4_grafcet_t *c, const inputs_t *i, outputs_t *q) {
    c->stable = true;
    for (uint8_t left = 10;; left--) {
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
