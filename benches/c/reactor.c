// A reactor: one branch heats and cools, the other doses and stirs.

#include "chart.h"

typedef struct {
    bool start, good;
    uint16_t level, pressure;
    int16_t temperature;
} inputs_t;

typedef struct {
    bool ready, inlet_a, inlet_b, stirrer, dose, cooler, vent, drain, sampled;
    uint16_t power;
} outputs_t;

// From HEAT on the other branch is beside them.
enum { IDLE, FILL_A, FILL_B, SAMPLE, DRAIN, RINSE, INIT, HEAT, HOLD, COOL, COOLED };
enum { STIR, DOSE, MIX, VENT, REST, MIXED };

typedef struct {
    // A pressure that stays high for 49.7 days vents one second more: the counter wraps.
    uint32_t since, stirring_since;
    uint8_t step, stirring;
} chart_t;

static inline bool stir(chart_t *c, const inputs_t *i, uint32_t now) {
    uint32_t time = now - c->stirring_since;
    switch (c->stirring) {
    case STIR:
        if (time < 2000) return false;
        c->stirring = DOSE;
        break;
    case DOSE:
        if (i->level < 900 && time < 3000) return false;
        c->stirring = MIX;
        break;
    case MIX:
        if (i->pressure >= 950) c->stirring = VENT;
        else if (time >= 4000) c->stirring = REST;
        else return false;
        break;
    case VENT:
        if (i->pressure >= 300 || time < 1000) return false;
        c->stirring = MIX;
        break;
    case REST:
        if (time < 1000) return false;
        c->stirring = MIXED;
        break;
    default: return false;
    }
    c->stirring_since = now;
    return true;
}

// One evolution; whether anything has moved.
static inline bool next(chart_t *c, const inputs_t *i, uint32_t now) {
    uint32_t time = now - c->since;
    bool mixed = c->stirring == MIXED, stirred = false;
    uint8_t step = c->step;
    if (step >= HEAT)
        stirred = stir(c, i, now);
    switch (step) {
    case IDLE: if (!i->start || i->level >= 50) return false; step = FILL_A; break;
    case FILL_A: if (i->level < 400) return false; step = FILL_B; break;
    case FILL_B: if (i->level < 700) return false; step = HEAT; break;
    case HEAT: if (i->temperature < 780) return stirred; step = HOLD; break;
    case HOLD: if (time < 5000) return stirred; step = COOL; break;
    case COOL: if (i->temperature >= 400) return stirred; step = COOLED; break;
    case COOLED: if (!mixed) return stirred; step = SAMPLE; break;
    case SAMPLE: if (time < 2000) return false; step = i->good ? DRAIN : HEAT; break;
    case DRAIN: if (i->level >= 20) return false; step = RINSE; break;
    case RINSE: if (time < 3000) return false; step = IDLE; break;
    default: step = IDLE;
    }
    if (step == HEAT) {
        c->stirring = STIR;
        c->stirring_since = now;
    }
    c->step = step;
    c->since = now;
    return true;
}

static inline void act(const chart_t *c, const inputs_t *i, outputs_t *q) {
    q->ready = q->inlet_a = q->inlet_b = q->stirrer = q->dose = q->cooler = q->vent = q->drain = q->sampled = false;
    q->power = 0;
    switch (c->step) {
    case IDLE: q->ready = true; return;
    case FILL_A: q->inlet_a = true; return;
    case FILL_B: q->inlet_b = true; return;
    case SAMPLE: q->sampled = true; return;
    case DRAIN: q->drain = true; return;
    case RINSE: q->inlet_a = q->drain = true; return;
    case HEAT: q->power = 1000; break;
    case HOLD: q->power = i->temperature < 780 ? 400 : 100; break;
    case COOL: q->cooler = true; break;
    }
    switch (c->stirring) {
    case DOSE: q->dose = q->stirrer = true; break;
    case STIR: case MIX: q->stirrer = true; break;
    case VENT: q->vent = true; break;
    }
}

// IEC 61131-3: one evolution per cycle; that of the first activates the initial step.
void reactor_sfc_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    next(c, i, now);
    act(c, i, q);
}

// IEC 60848: evolutions until nothing moves; the times end every search.
void reactor_grafcet_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    while (next(c, i, now)) {}
    act(c, i, q);
}
