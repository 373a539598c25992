/* lighting_option.c - reads and checks the options for electric light. */
#include "cli/annual/lighting_option.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "studies/lighting/lighting_control.h"

/* A key of --lighting. kinds: bit mask of the kinds of control that accept the key. */
struct lighting_key {
    const char *name;
    unsigned kinds;
    enum pp_status (*read)(struct pp_lighting_control *control, const char *text,
                           struct pp_error *err);
};

enum {
    ON_OFF = 1 << PP_LIGHTING_ON_OFF,
    STEPPED = 1 << PP_LIGHTING_STEPPED,
    DIMMED = 1 << PP_LIGHTING_DIMMED,
    MANUAL = 1 << PP_LIGHTING_MANUAL,
    AUTOMATIC = ON_OFF | STEPPED | DIMMED,
};

/* Reads a number from `low` to `high`, with or without a unit after it. */
static bool read_lighting_number(const char *text, const char *unit, double low,
                                 double high, double *number)
{
    char copy[32];
    size_t length = strlen(text), tail = strlen(unit);
    if (length >= sizeof copy)
        return false;
    memcpy(copy, text, length + 1);
    if (length > tail && strcmp(copy + length - tail, unit) == 0)
        copy[length - tail] = '\0';
    return pp_text_parse_number(copy, number) && *number >= low && *number <= high;
}

static enum pp_status read_power(struct pp_lighting_control *control, const char *text,
                                 struct pp_error *err)
{
    double number;
    bool is_total = false;
    if (!read_lighting_number(text, "W/m2", 0.01, 1000.0, &number)) {
        size_t length = strlen(text);
        is_total = length > 1 && text[length - 1] == 'W';
        if (!is_total || !read_lighting_number(text, "W", 0.01, 1e7, &number))
            return pp_fail(err, PP_BAD_INPUT,
                           "installed power in W/m2 from 0.01 to 1000, or with W in "
                           "watts, such as power=8 or power=400W");
    }
    control->power_w = is_total ? number : NAN;
    control->power_w_m2 = is_total ? NAN : number;
    return PP_OK;
}

static enum pp_status read_target(struct pp_lighting_control *control, const char *text,
                                  struct pp_error *err)
{
    if (!read_lighting_number(text, "lx", 1.0, 1e5, &control->target_lx))
        return pp_fail(err, PP_BAD_INPUT, "target=LX from 1 to 100000");
    return PP_OK;
}

static enum pp_status read_differential(struct pp_lighting_control *control,
                                        const char *text, struct pp_error *err)
{
    if (!read_lighting_number(text, "lx", 0.0, 1e5, &control->differential_lx))
        return pp_fail(err, PP_BAD_INPUT, "differential=LX from 0 to 100000");
    return PP_OK;
}

static enum pp_status read_steps(struct pp_lighting_control *control, const char *text,
                                 struct pp_error *err)
{
    double number;
    if (!read_lighting_number(text, "", 1.0, 20.0, &number) || number != floor(number))
        return pp_fail(err, PP_BAD_INPUT, "steps=N from 1 to 20");
    control->steps = (int)number;
    return PP_OK;
}

static enum pp_status read_residual_light(struct pp_lighting_control *control,
                                          const char *text, struct pp_error *err)
{
    if (!read_lighting_number(text, "", 0.0, 0.99, &control->residual_light))
        return pp_fail(err, PP_BAD_INPUT,
                       "residual-light=F, a fraction from 0 to 0.99");
    return PP_OK;
}

static enum pp_status read_residual_power(struct pp_lighting_control *control,
                                          const char *text, struct pp_error *err)
{
    if (!read_lighting_number(text, "", 0.0, 1.0, &control->residual_power))
        return pp_fail(err, PP_BAD_INPUT, "residual-power=F, a fraction from 0 to 1");
    return PP_OK;
}

static enum pp_status read_end(struct pp_lighting_control *control, const char *text,
                               struct pp_error *err)
{
    control->switches_off = strcmp(text, "off") == 0;
    if (!control->switches_off && strcmp(text, "residual") != 0)
        return pp_fail(err, PP_BAD_INPUT, "end=off or end=residual");
    return PP_OK;
}

static enum pp_status read_at(struct pp_lighting_control *control, const char *text,
                              struct pp_error *err)
{
    double number = 0.0;
    if (strcmp(text, "darkest") != 0
        && (!pp_text_parse_number(text, &number) || number < 1.0 || number > 1e6
            || number != floor(number)))
        return pp_fail(err, PP_BAD_INPUT,
                       "at=darkest, or at=N, the number of a point from 1");
    control->point = (int)number;
    return PP_OK;
}

static enum pp_status read_lighting_blinds(struct pp_lighting_control *control,
                                           const char *text, struct pp_error *err)
{
    control->with_blinds = strcmp(text, "lm83") == 0;
    if (!control->with_blinds && strcmp(text, "open") != 0)
        return pp_fail(err, PP_BAD_INPUT, "blinds=open or blinds=lm83");
    return PP_OK;
}

static const struct lighting_key keys[] = {
    {"power", AUTOMATIC | MANUAL, read_power},
    {"target", AUTOMATIC | MANUAL, read_target},
    {"differential", ON_OFF, read_differential},
    {"steps", STEPPED, read_steps},
    {"residual-light", DIMMED, read_residual_light},
    {"residual-power", DIMMED, read_residual_power},
    {"end", DIMMED, read_end},
    {"at", AUTOMATIC | MANUAL, read_at},
    {"blinds", AUTOMATIC | MANUAL, read_lighting_blinds},
};

enum { KEYS = sizeof keys / sizeof *keys };

/* Returns an error that lists the keys accepted by this kind of control. */
static enum pp_status fail_key(enum pp_lighting_kind kind, struct pp_error *err)
{
    const char *names[KEYS];
    char list[160] = "";
    int count = 0;
    for (int i = 0; i < KEYS; i++)
        if (keys[i].kinds >> kind & 1)
            names[count++] = keys[i].name;
    pp_text_append_list(list, sizeof list, names, count, " or ");
    return pp_fail(err, PP_BAD_INPUT, "%s with KEY=VALUE, where KEY is %s",
                   pp_lighting_control_name(kind), list);
}

/* Reads one item, KEY=VALUE. The text is modified. */
static enum pp_status read_lighting_word(struct pp_lighting_control *control,
                                         char *word, struct pp_error *err)
{
    char *value = strchr(word, '=');
    if (!value)
        return fail_key(control->kind, err);
    *value++ = '\0';
    for (int i = 0; i < KEYS; i++)
        if (strcmp(word, keys[i].name) == 0 && keys[i].kinds >> control->kind & 1)
            return keys[i].read(control, value, err);
    return fail_key(control->kind, err);
}

static bool read_kind(const char *word, enum pp_lighting_kind *kind)
{
    for (int i = PP_LIGHTING_ON_OFF; i <= PP_LIGHTING_MANUAL; i++)
        if (strcmp(word, pp_lighting_control_name((enum pp_lighting_kind)i)) == 0) {
            *kind = (enum pp_lighting_kind)i;
            return true;
        }
    return false;
}

static enum pp_status read_lighting(const char *text, void *place, struct pp_error *err)
{
    struct pp_lighting_choice *choice = place;
    struct pp_lighting_control control = {
        .steps = 2, .power_w = NAN, .power_w_m2 = NAN};
    char copy[400];
    if (choice->count == PP_LIGHTING_CONTROLS_MOST)
        return pp_fail(err, PP_BAD_INPUT, "at most %d controls",
                       PP_LIGHTING_CONTROLS_MOST);
    if (strlen(text) >= sizeof copy)
        return pp_fail(err, PP_BAD_INPUT, "a shorter text");
    strcpy(copy, text);
    char *word = copy, *next = strchr(copy, ',');
    if (next)
        *next++ = '\0';
    if (!read_kind(word, &control.kind))
        return pp_fail(err, PP_BAD_INPUT,
                       "on-off, stepped, dimmed or manual, followed by ,KEY=VALUE for "
                       "each setting");
    for (word = next; word; word = next) {
        next = strchr(word, ',');
        if (next)
            *next++ = '\0';
        enum pp_status status = read_lighting_word(&control, word, err);
        if (status != PP_OK)
            return status;
    }
    choice->list[choice->count++] = control;
    return PP_OK;
}

const struct pp_option pp_lighting_options[] = {
    {"lighting", 0, "CONTROL[,KEY=VALUE...]",
     "Electric light saved by daylight under a control: on-off, stepped, dimmed or "
     "manual. Keys: power=W/m2 or power=400W, installed power; target=LX (default: the "
     "first of --illuminance); at=darkest (default) or at=N, control point; "
     "blinds=open "
     "(default) or lm83. on-off: differential=LX (default 0). stepped: steps=N "
     "(default "
     "2). dimmed: residual-light=F and residual-power=F, fractions (default 0), "
     "end=residual (default) or off. Repeat the option for several controls.",
     read_lighting, 0},
    {"schedule", 0, "FILE.csv",
     "Also write the fraction of the installed lighting power in each hour of the "
     "year, "
     "for thermal simulation.",
     pp_options_read_output, offsetof(struct pp_lighting_choice, schedule)},
    {0},
};

enum pp_status pp_lighting_option_check(const struct pp_lighting_choice *choice,
                                        const char *no_blinds, struct pp_error *err)
{
    for (int k = 0; k < choice->count; k++)
        if (choice->list[k].with_blinds && no_blinds)
            return pp_fail(err, PP_BAD_INPUT,
                           "--lighting with blinds=lm83 cannot be combined with %s",
                           no_blinds);
    if (choice->schedule && choice->count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--schedule needs --lighting, such as --lighting "
                       "dimmed,power=8");
    return PP_OK;
}

void pp_lighting_option_settle(struct pp_annual_options *annual,
                               const struct pp_lighting_choice *choice)
{
    annual->lighting_count = choice->count;
    for (int k = 0; k < choice->count; k++) {
        annual->lighting[k] = choice->list[k];
        if (!(annual->lighting[k].target_lx > 0.0))
            annual->lighting[k].target_lx = annual->illuminances_lx[0];
    }
}
