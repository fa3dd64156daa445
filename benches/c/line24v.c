// The production line.

#include "chart.h"

typedef struct {
    bool b1, b2, b3, b4, b5;
} inputs_t;

typedef struct {
    bool q1, q2, q3;
} outputs_t;

enum { S1, S2, S3, S4, INIT };

static inline uint8_t next(uint8_t step, const inputs_t *i) {
    switch (step) {
    case S1: if (i->b1) return S2; break;
    case S2: if (i->b2) return S3; break;
    case S3: if (i->b3) return S4; break;
    case S4: if (i->b4) return S1; break;
    }
    return step;
}

static inline void act(uint8_t step, bool q2, const inputs_t *i, outputs_t *q) {
    q->q1 = step == S1;
    q->q2 = q2;
    q->q3 = step == S3 && i->b5;
}

typedef struct {
    uint8_t step;
    bool q2;
} line24v_sfc_t;

// IEC 61131-3: one evolution per cycle, none in the first.
void line24v_sfc_cycle(line24v_sfc_t *c, const inputs_t *i, outputs_t *q) {
    c->step = c->step == INIT ? S1 : next(c->step, i);
    if (c->step == S2)
        c->q2 = true;
    else if (c->step == S4)
        c->q2 = false;
    act(c->step, c->q2, i, q);
}

typedef struct {
    uint8_t step;
    bool q2;
    bool stable;
} line24v_grafcet_t;

// IEC 60848: evolutions until the step stays, at most twice the number of steps plus two.
void line24v_grafcet_cycle(line24v_grafcet_t *c, const inputs_t *i, outputs_t *q) {
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
        if (c->step == S2)
            c->q2 = true;
        else if (c->step == S4)
            c->q2 = false;
    }
    act(c->step, c->q2, i, q);
}
