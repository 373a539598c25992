/* sweep_options.c - see sweep_options.h. */
#include "cli/sweep/sweep_options.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"

/* Finds the "=" after an address, which contains a dot. NULL: there is none. */
static const char *behind_address(const char *text)
{
    const char *equals = strchr(text, '=');
    return equals && memchr(text, '.', (size_t)(equals - text)) ? equals : NULL;
}

static enum pp_status add_change(const char *text, void *place, struct pp_error *err)
{
    struct pp_sweep *sweep = place;
    const char *equals = behind_address(text);
    if (!equals)
        return pp_fail(err, PP_BAD_INPUT,
                       "PART.ATTRIBUTE=VALUE, such as window.W1.width=1.4 or "
                       "finishes.walls=0.6");
    if (pp_array_append(&sweep->set, sweep->set_count, sizeof *sweep->set, err)
        != PP_OK)
        return PP_SYSTEM;
    char *address = strndup(text, (size_t)(equals - text)), *value = strdup(equals + 1);
    sweep->set[sweep->set_count++] = (struct pp_room_change){address, value};
    return address && value ? PP_OK : pp_fail_memory(err);
}

static enum pp_status add_value(struct pp_sweep_axis *axis, const char *text,
                                size_t length, struct pp_error *err)
{
    if (pp_array_append(&axis->values, axis->count, sizeof *axis->values, err) != PP_OK)
        return PP_SYSTEM;
    axis->values[axis->count] = strndup(text, length);
    return axis->values[axis->count++] ? PP_OK : pp_fail_memory(err);
}

static enum pp_status refuse_values(struct pp_error *err)
{
    return pp_fail(
        err, PP_BAD_INPUT,
        "PART.ATTRIBUTE=FROM:TO:STEP or PART.ATTRIBUTE=A,B,..., with at most "
        "%d values, such as window.W1.width=0.8:2.4:0.2",
        PP_SWEEP_RUNS_MOST);
}

/* Adds the values of a range FROM:TO:STEP. TO is included if its distance from FROM is
 * a multiple of STEP, with a tolerance of a millionth of STEP. */
static enum pp_status add_range(struct pp_sweep_axis *axis, const char *text,
                                struct pp_error *err)
{
    double v[3];
    if (pp_options_numbers(text, ':', v, 3) != 3)
        return refuse_values(err);
    double steps = floor((v[1] - v[0]) / v[2] + 1e-6);
    if (!(steps >= 0.0 && steps < PP_SWEEP_RUNS_MOST))
        return refuse_values(err);
    enum pp_status status = PP_OK;
    for (int i = 0; i <= (int)steps && status == PP_OK; i++) {
        char number[40];
        snprintf(number, sizeof number, "%.10g", v[0] + i * v[2] + 0.0);
        status = add_value(axis, number, strlen(number), err);
    }
    return status;
}

static enum pp_status add_words(struct pp_sweep_axis *axis, const char *text,
                                struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (const char *end; status == PP_OK; text = end + 1) {
        end = text + strcspn(text, ",");
        status = end > text && axis->count < PP_SWEEP_RUNS_MOST
                     ? add_value(axis, text, (size_t)(end - text), err)
                     : refuse_values(err);
        if (!*end)
            break;
    }
    return status;
}

static enum pp_status add_axis(const char *text, void *place, struct pp_error *err)
{
    struct pp_sweep *sweep = place;
    const char *equals = behind_address(text);
    if (!equals)
        return refuse_values(err);
    if (sweep->axis_count == PP_SWEEP_AXES_MOST)
        return pp_fail(err, PP_BAD_INPUT, "at most %d sweeps", PP_SWEEP_AXES_MOST);
    struct pp_sweep_axis *axis = &sweep->axes[sweep->axis_count++];
    axis->address = strndup(text, (size_t)(equals - text));
    if (!axis->address)
        return pp_fail_memory(err);
    return strchr(equals, ':') ? add_range(axis, equals + 1, err)
                               : add_words(axis, equals + 1, err);
}

const struct pp_option pp_sweep_options[] = {
    {"set", 0, "PART.ATTRIBUTE=VALUE",
     "Change an attribute in the room file: window.W1.width=1.4, plan.depth=5, "
     "finishes.walls=0.6. Address a part by its name, its wall or its number; "
     "window.width changes every window. Repeat the option to change several "
     "attributes.",
     add_change, 0},
    {"sweep", 0, "PART.ATTRIBUTE=FROM:TO:STEP",
     "Run once for each of these values, or for each value in a list A,B,...; all "
     "results form one table. Repeat the option to combine several sweeps.",
     add_axis, 0},
    {0},
};

enum pp_status pp_sweep_options_check(const struct pp_sweep *sweep,
                                      struct pp_error *err)
{
    return pp_sweep_count(sweep) <= PP_SWEEP_RUNS_MOST
               ? PP_OK
               : pp_fail(err, PP_BAD_INPUT,
                         "--sweep: the combined sweeps have more than %d runs; "
                         "expected fewer",
                         PP_SWEEP_RUNS_MOST);
}
