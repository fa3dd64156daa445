// A washing machine: loops back for water and for another rinse.

#include "chart.h"

typedef struct {
    bool start, full, hot, washed, empty, again, spun;
} inputs_t;

typedef struct {
    bool ready, locked, valve, heater, drum, pump, spin;
} outputs_t;

enum { IDLE, FILL, HEAT, WASH, DRAIN, SPIN, DONE, INIT };

static inline uint8_t next(uint8_t step, const inputs_t *i) {
    switch (step) {
    case IDLE: if (i->start) return FILL; break;
    case FILL: if (i->full) return HEAT; break;
    case HEAT: if (i->hot) return WASH; break;
    case WASH: if (i->washed) return DRAIN; if (!i->full) return FILL; break;
    case DRAIN: if (i->empty) return i->again ? FILL : SPIN; break;
    case SPIN: if (i->spun) return DONE; break;
    case DONE: if (!i->start) return IDLE; break;
    }
    return step;
}

static inline void act(uint8_t step, bool locked, const inputs_t *i, outputs_t *q) {
    q->ready = q->valve = q->heater = q->drum = q->pump = q->spin = false;
    q->locked = locked;
    switch (step) {
    case IDLE: q->ready = true; break;
    case FILL: q->valve = true; break;
    case HEAT: q->heater = true; break;
    case WASH: q->drum = true; q->heater = !i->hot; break;
    case DRAIN: q->pump = true; break;
    case SPIN: q->pump = q->spin = true; break;
    }
}

typedef struct {
    uint8_t step;
    bool locked;
} washer_sfc_t;

// IEC 61131-3: one evolution per cycle, none in the first.
void washer_sfc_cycle(washer_sfc_t *c, const inputs_t *i, outputs_t *q) {
    c->step = c->step == INIT ? IDLE : next(c->step, i);
    if (c->step == FILL)
        c->locked = true;
    else if (c->step == DONE)
        c->locked = false;
    act(c->step, c->locked, i, q);
}

typedef struct {
    uint8_t step;
    bool locked;
    bool stable;
} washer_grafcet_t;

// IEC 60848: evolutions until the step stays, at most twice the number of steps plus two.
void washer_grafcet_cycle(washer_grafcet_t *c, const inputs_t *i, outputs_t *q) {
    c->stable = true;
    for (uint8_t left = 16;; left--) {
        uint8_t step = next(c->step, i);
        if (step == c->step)
            break;
        if (left == 0) {
            c->stable = false;
            break;
        }
        c->step = step;
        if (c->step == FILL)
            c->locked = true;
        else if (c->step == DONE)
            c->locked = false;
    }
    act(c->step, c->locked, i, q);
}
