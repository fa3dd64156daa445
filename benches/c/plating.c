// The plating line of 40 steps.

#include "chart.h"

typedef struct {
    bool start, there, low, high, good, home;
    uint8_t recipe;
} inputs_t;

typedef struct {
    bool ready, grip, forward, backward, lower, lift, heat, water, current, air, reject;
    uint16_t parts;
} outputs_t;

enum {
    IDLE, GRIP, RAISE,
    TO_DEGREASE, LOWER_DEGREASE, DEGREASE, LIFT_DEGREASE, DRIP_DEGREASE,
    TO_RINSE, LOWER_RINSE, RINSE, LIFT_RINSE, DRIP_RINSE,
    TO_NICKEL, LOWER_NICKEL, NICKEL, LIFT_NICKEL, DRIP_NICKEL,
    TO_CHROME, LOWER_CHROME, CHROME, LIFT_CHROME, DRIP_CHROME,
    TO_ZINC, LOWER_ZINC, ZINC, LIFT_ZINC, DRIP_ZINC,
    TO_CLEAN, LOWER_CLEAN, CLEAN, LIFT_CLEAN, DRIP_CLEAN,
    TO_DRYER, DRY, INSPECT, REWORK, REJECT, UNLOAD, RETURN, INIT,
};

typedef struct {
    // Where a step does not go on as soon as its time is over, the counter wraps in it after 49.7 days: DRIP_RINSE without a
    // recipe, REWORK without a sensor.
    uint32_t since;
    uint16_t parts;
    uint8_t step, dips, tries;
    bool grip;
} chart_t;

// One evolution; whether anything has moved.
static inline bool next(chart_t *c, const inputs_t *i, uint32_t now) {
    uint32_t time = now - c->since;
    uint8_t step = c->step;
    switch (step) {
    // What goes on to the step after it.
    case GRIP: if (time < 500) return false; step++; break;
    case DRIP_DEGREASE: case RINSE: case CLEAN: case DRIP_CLEAN: if (time < 1000) return false; step++; break;
    case ZINC: if (time < 2000) return false; step++; break;
    case DEGREASE: case NICKEL: if (time < 3000) return false; step++; break;
    case DRY: if (time < 4000) return false; step++; break;
    case CHROME: if (time < 5000) return false; step++; break;
    case TO_DEGREASE: case TO_RINSE: case TO_NICKEL: case TO_CHROME: case TO_ZINC: case TO_CLEAN: case TO_DRYER:
        if (!i->there) return false;
        step++;
        break;
    case LOWER_DEGREASE: case LOWER_NICKEL: case LOWER_CHROME: case LOWER_ZINC:
        if (!i->low) return false;
        step++;
        break;
    case RAISE: case LIFT_DEGREASE: case LIFT_NICKEL: case LIFT_CHROME: case LIFT_ZINC:
        if (!i->high) return false;
        step++;
        break;
    case LOWER_RINSE: case LOWER_CLEAN:
        if (!i->low) return false;
        c->dips++;
        step++;
        break;
    // What goes elsewhere, too.
    case IDLE:
        if (!i->start || !i->home) return false;
        c->grip = true;
        step = GRIP;
        break;
    case LIFT_RINSE:
        if (!i->high) return false;
        if (c->dips < 3) {
            step = LOWER_RINSE;
        } else {
            c->dips = 0;
            step = DRIP_RINSE;
        }
        break;
    case DRIP_RINSE:
        if (time < 1000) return false;
        switch (i->recipe) {
        case 1: step = TO_NICKEL; break;
        case 2: step = TO_CHROME; break;
        case 3: step = TO_ZINC; break;
        default: return false;
        }
        break;
    case DRIP_NICKEL: case DRIP_CHROME: case DRIP_ZINC: if (time < 1000) return false; step = TO_CLEAN; break;
    case LIFT_CLEAN:
        if (!i->high) return false;
        if (c->dips < 2) {
            step = LOWER_CLEAN;
        } else {
            c->dips = 0;
            step = DRIP_CLEAN;
        }
        break;
    case INSPECT:
        if (i->good) {
            c->parts++;
            step = UNLOAD;
        } else if (c->tries < 2) {
            c->tries++;
            step = REWORK;
            break;
        } else {
            step = REJECT;
        }
        c->grip = false;
        c->tries = 0;
        break;
    case REWORK: if (!i->there || time < 500) return false; step = LOWER_RINSE; break;
    case REJECT: if (time < 1000) return false; step = RETURN; break;
    case UNLOAD: if (!i->low) return false; step = RETURN; break;
    case RETURN: if (!i->home) return false; step = IDLE; break;
    default: step = IDLE;
    }
    c->step = step;
    c->since = now;
    return true;
}

static inline void act(const chart_t *c, outputs_t *q) {
    q->ready = q->forward = q->backward = q->lower = q->lift = false;
    q->heat = q->water = q->current = q->air = q->reject = false;
    q->grip = c->grip;
    q->parts = c->parts;
    switch (c->step) {
    case IDLE: q->ready = true; break;
    case TO_DEGREASE: case TO_RINSE: case TO_NICKEL: case TO_CHROME: case TO_ZINC: case TO_CLEAN: case TO_DRYER:
        q->forward = true;
        break;
    case LOWER_DEGREASE: case LOWER_RINSE: case LOWER_NICKEL: case LOWER_CHROME: case LOWER_ZINC: case LOWER_CLEAN:
    case UNLOAD:
        q->lower = true;
        break;
    case RAISE: case LIFT_DEGREASE: case LIFT_RINSE: case LIFT_NICKEL: case LIFT_CHROME: case LIFT_ZINC: case LIFT_CLEAN:
        q->lift = true;
        break;
    case DEGREASE: q->heat = true; break;
    case RINSE: case CLEAN: q->water = true; break;
    case NICKEL: q->current = true; break;
    case CHROME: q->current = q->heat = true; break;
    case ZINC: q->current = q->air = true; break;
    case DRY: q->air = q->heat = true; break;
    case REWORK: case RETURN: q->backward = true; break;
    case REJECT: q->reject = true; break;
    }
}

// IEC 61131-3: one evolution per cycle; that of the first activates the initial step.
void plating_sfc_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    next(c, i, now);
    act(c, q);
}

// IEC 60848: evolutions until nothing moves; the times end every search.
void plating_grafcet_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    while (next(c, i, now)) {}
    act(c, q);
}
