// A selection of eight branches.

#include "chart.h"

typedef struct {
    bool start, done;
    uint8_t recipe;
} inputs_t;

typedef struct {
    bool ready, pump, v1, v2, v3, v4, v5, v6, v7, v8;
} outputs_t;

enum { IDLE, A1, A2, A3, A4, A5, A6, A7, A8, INIT };

static inline uint8_t next(uint8_t step, const inputs_t *i) {
    if (step != IDLE)
        return i->done ? IDLE : step;
    // The recipes are numbered as their steps are.
    return i->start && i->recipe <= A8 ? i->recipe : IDLE;
}

static inline void act(uint8_t step, outputs_t *q) {
    q->ready = step == IDLE;
    q->pump = step != IDLE;
    q->v1 = q->v2 = q->v3 = q->v4 = q->v5 = q->v6 = q->v7 = q->v8 = false;
    switch (step) {
    case A1: q->v1 = true; break;
    case A2: q->v2 = true; break;
    case A3: q->v3 = true; break;
    case A4: q->v4 = true; break;
    case A5: q->v5 = true; break;
    case A6: q->v6 = true; break;
    case A7: q->v7 = true; break;
    case A8: q->v8 = true; break;
    }
}

typedef struct {
    uint8_t step;
} selection_sfc_t;

// IEC 61131-3: one evolution per cycle, none in the first.
void selection_sfc_cycle(selection_sfc_t *c, const inputs_t *i, outputs_t *q) {
    c->step = c->step == INIT ? IDLE : next(c->step, i);
    act(c->step, q);
}

typedef struct {
    uint8_t step;
    bool stable;
} selection_grafcet_t;

// IEC 60848: evolutions until the step stays, at most twice the number of steps plus two.
void selection_grafcet_cycle(selection_grafcet_t *c, const inputs_t *i, outputs_t *q) {
    c->stable = true;
    for (uint8_t left = 20;; left--) {
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
