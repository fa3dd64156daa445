// The motor.

#include "chart.h"

typedef struct {
    bool on, off, over_temp;
} inputs_t;

typedef struct {
    bool relay, green, red;
} outputs_t;

enum { OFF, ON, INIT };

static inline uint8_t next(uint8_t step, const inputs_t *i) {
    switch (step) {
    case OFF: if (i->on && !i->over_temp) return ON; break;
    case ON: if (i->off || i->over_temp) return OFF; break;
    }
    return step;
}

static inline void act(uint8_t step, outputs_t *q) {
    q->relay = q->green = step == ON;
    q->red = step == OFF;
}

typedef struct {
    uint8_t step;
} motor_sfc_t;

// IEC 61131-3: one evolution per cycle, none in the first.
void motor_sfc_cycle(motor_sfc_t *c, const inputs_t *i, outputs_t *q) {
    c->step = c->step == INIT ? OFF : next(c->step, i);
    act(c->step, q);
}

typedef struct {
    uint8_t step;
    bool stable;
} motor_grafcet_t;

// IEC 60848: evolutions until the step stays, at most twice the number of steps plus two.
void motor_grafcet_cycle(motor_grafcet_t *c, const inputs_t *i, outputs_t *q) {
    c->stable = true;
    for (uint8_t left = 6;; left--) {
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
