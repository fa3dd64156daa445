// The washing machine of 25 steps.

#include "chart.h"

typedef struct {
    bool start, door, full, hot, empty, balanced;
} inputs_t;

typedef struct {
    bool ready, locked, valve, heater, left, right, pump, slow, fast, alarm;
} outputs_t;

enum {
    IDLE, LOCK, FILL, NO_WATER, HEAT, WASH_LEFT, WASH_REST_1, WASH_RIGHT, WASH_REST_2, DRAIN, DRAIN_MORE,
    RINSE_FILL, RINSE_LEFT, RINSE_REST, RINSE_RIGHT, RINSE_DRAIN, RINSE_MORE,
    SPREAD, RAMP, SPIN_SLOW, SPIN_FAST, COAST, LOOSEN, UNLOCK, DONE, INIT,
};

typedef struct {
    // In a step that waits for a sensor the counter wraps after 49.7 days, and it waits for its longest time once more.
    uint32_t since;
    uint8_t step, turns, rinses;
    bool locked;
} chart_t;

// One evolution; whether anything has moved.
static inline bool next(chart_t *c, const inputs_t *i, uint32_t now) {
    uint32_t time = now - c->since;
    uint8_t step;
    switch (c->step) {
    case IDLE:
        if (!i->start || !i->door) return false;
        c->locked = true;
        step = LOCK;
        break;
    case LOCK: if (time < 500) return false; step = FILL; break;
    case FILL:
        if (i->full) step = HEAT;
        else if (time >= 10000) step = NO_WATER;
        else return false;
        break;
    case NO_WATER:
        if (i->start) return false;
        c->locked = false;
        step = UNLOCK;
        break;
    case HEAT:
        if (!i->hot && time < 20000) return false;
        c->turns++;
        step = WASH_LEFT;
        break;
    case WASH_LEFT: if (time < 3000) return false; step = WASH_REST_1; break;
    case WASH_REST_1: if (time < 1000) return false; step = WASH_RIGHT; break;
    case WASH_RIGHT: if (time < 3000) return false; step = WASH_REST_2; break;
    case WASH_REST_2:
        if (time < 1000) return false;
        if (c->turns < 4) {
            c->turns++;
            step = WASH_LEFT;
        } else {
            c->turns = 0;
            step = DRAIN;
        }
        break;
    case DRAIN: if (!i->empty) return false; step = DRAIN_MORE; break;
    case DRAIN_MORE: if (time < 2000) return false; step = RINSE_FILL; break;
    case RINSE_FILL:
        if (!i->full) return false;
        c->rinses++;
        step = RINSE_LEFT;
        break;
    case RINSE_LEFT: if (time < 2000) return false; step = RINSE_REST; break;
    case RINSE_REST: if (time < 500) return false; step = RINSE_RIGHT; break;
    case RINSE_RIGHT: if (time < 2000) return false; step = RINSE_DRAIN; break;
    case RINSE_DRAIN: if (!i->empty) return false; step = RINSE_MORE; break;
    case RINSE_MORE:
        if (time < 2000) return false;
        if (c->rinses < 3) {
            step = RINSE_FILL;
        } else {
            c->rinses = 0;
            step = SPREAD;
        }
        break;
    case SPREAD:
        if (i->balanced) {
            if (time < 2000) return false;
            step = RAMP;
        } else {
            if (time < 8000) return false;
            step = COAST;
        }
        break;
    case RAMP: if (time < 1000) return false; step = SPIN_SLOW; break;
    case SPIN_SLOW: if (time < 4000) return false; step = SPIN_FAST; break;
    case SPIN_FAST: if (time < 6000) return false; step = COAST; break;
    case COAST: if (time < 2000) return false; step = LOOSEN; break;
    case LOOSEN:
        if (time < 1000) return false;
        c->locked = false;
        step = UNLOCK;
        break;
    case UNLOCK: if (time < 1000) return false; step = DONE; break;
    case DONE: if (i->door || time < 1000) return false; step = IDLE; break;
    default: step = IDLE;
    }
    c->step = step;
    c->since = now;
    return true;
}

static inline void act(const chart_t *c, const inputs_t *i, outputs_t *q) {
    q->ready = q->valve = q->heater = q->left = q->right = q->pump = q->slow = q->fast = q->alarm = false;
    q->locked = c->locked;
    switch (c->step) {
    case IDLE: q->ready = true; break;
    case FILL: case RINSE_FILL: q->valve = true; break;
    case NO_WATER: q->alarm = true; break;
    case HEAT: q->heater = q->left = true; break;
    case WASH_LEFT: q->left = true; q->heater = !i->hot; break;
    case WASH_RIGHT: q->right = true; q->heater = !i->hot; break;
    case RINSE_LEFT: q->left = true; break;
    case RINSE_RIGHT: case LOOSEN: q->right = true; break;
    case DRAIN: case DRAIN_MORE: case RINSE_DRAIN: case RINSE_MORE: case COAST: q->pump = true; break;
    case SPREAD: q->left = q->pump = true; break;
    case RAMP: case SPIN_SLOW: q->slow = q->pump = true; break;
    case SPIN_FAST: q->fast = q->pump = true; break;
    case DONE: q->ready = true; q->alarm = i->door; break;
    }
}

// IEC 61131-3: one evolution per cycle; that of the first activates the initial step.
void laundry_sfc_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    next(c, i, now);
    act(c, i, q);
}

// IEC 60848: evolutions until nothing moves; the times end every search.
void laundry_grafcet_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    while (next(c, i, now)) {}
    act(c, i, q);
}
