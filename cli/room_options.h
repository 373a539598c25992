/* room_options.h - the options that every command on a room has, with one meaning. */
#ifndef PP_CLI_ROOM_OPTIONS_H
#define PP_CLI_ROOM_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "cli/options.h"
#include "methods/method.h"
#include "model/room/world.h"

/* Points of --points; z is NAN for the working plane. */
struct pp_point_list {
    struct pp_vec3 *list;
    int count;
};

struct pp_room_options {
    const char *methods; /* as typed; NULL: the default ones */
    struct pp_point_list points;
    const char *sky;  /* as typed; NULL: the file's */
    const char *room; /* only the rooms of that name; NULL: all */

    bool simulate;
    double error;   /* wanted standard error over daylight factor; 0: not given */
    long samples;   /* paths a point in each randomisation; 0: not given */
    double seconds; /* 0: not given */
    uint64_t seed;
    int threads; /* 0: as many as there are processors */

    bool explain; /* df: set out the sums of its one point */
    struct pp_method_options method_options;

    double external_lux; /* of the open level plane; 0: not given */

    const char *output; /* NULL: standard output */
    bool quiet;
};

/* Nothing asked for: seed 1, all else empty. */
extern const struct pp_room_options pp_room_options_none;

/* Lists for struct pp_option_group, with a struct pp_room_options as values. */
extern const struct pp_option pp_room_choice_options[];     /* methods, points, sky */
extern const struct pp_option pp_room_external_option[];    /* external */
extern const struct pp_option *const pp_room_place_options; /* points, sky, room */
extern const struct pp_option *const pp_room_sky_options;   /* sky, room */
extern const struct pp_option pp_room_simulation_options[]; /* simulate ... threads */
extern const struct pp_option *const pp_room_seed_options;  /* seed, threads */
extern const struct pp_option pp_room_output_options[];     /* output, quiet */

/* Do the options make sense together? PP_BAD_INPUT if not. A simulation without an end
 * gets an error of 1 %. */
enum pp_status pp_room_options_settle(struct pp_room_options *options,
                                      struct pp_error *err);

void pp_room_options_clear(struct pp_room_options *options);

#endif
