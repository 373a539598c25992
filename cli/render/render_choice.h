/* render_choice.h - the options of the command render. */
#ifndef PP_CLI_RENDER_RENDER_CHOICE_H
#define PP_CLI_RENDER_RENDER_CHOICE_H

#include <stdbool.h>

#include "charts/sheet/canvas.h"
#include "cli/cache_choice.h"
#include "cli/room_options.h"
#include "cli/chart/sheet_options.h"
#include "cli/render/picture_format.h"
#include "model/pictures/quantity.h"
#include "model/pictures/tone.h"
#include "simulate/render/render.h"

enum pp_view_choice {
    PP_CHOOSE_PERSPECTIVE,
    PP_CHOOSE_PARALLEL,
    PP_CHOOSE_PLAN,
    PP_CHOOSE_SECTION,
    PP_CHOOSE_HEMISPHERICAL,
    PP_CHOOSE_ANGULAR,
};

/* "X,Y" or "X,Y,Z" as typed. */
struct pp_coordinates {
    int count; /* 0: not typed, 2 or 3 */
    struct pp_vec3 is;
};

enum { PP_LEVELS_MOST = 32 };

struct pp_levels {
    int count;
    double list[PP_LEVELS_MOST]; /* ascending, above 0, in the quantity's unit */
};

struct pp_exposure {
    enum pp_tone_way way;
    double white; /* value shown as white, set by the user, in the quantity's unit */
    bool said;
};

struct pp_picture_size {
    int width, height; /* 0: not given */
};

struct pp_quantity_choice {
    bool said;
    enum pp_quantity is;
};

struct pp_paper_choice {
    bool said;
    enum pp_paper is;
};

/* Sampling of light through windows. */
enum pp_window_light {
    PP_WINDOWS_STORED, /* next-event estimation; light from outside surfaces is
                        * calculated once and stored */
    PP_WINDOWS_AIMED,  /* next-event estimation along each path */
    PP_WINDOWS_CHANCE, /* BRDF sampling alone */
};

struct pp_render_choice {
    enum pp_view_choice view;
    struct pp_coordinates from, towards, direction, up;
    double angle_deg; /* 0: not given */
    double across_m;  /* 0: not given */
    struct pp_picture_size size;

    struct pp_quantity_choice quantity;
    enum pp_pixel_filter filter;
    int samples; /* before the check 0: not given */
    bool paths;  /* light paths only, without a cache */
    enum pp_window_light windows;
    struct pp_cache_choice cache;
    const char *checkpoint;
    const char *errors; /* file for the pixels' standard errors; NULL: none */

    struct pp_exposure exposure;
    bool false_colour;
    struct pp_levels range, levels; /* range: empty or two values */
    bool linear, no_contours;
    bool records; /* mark the cache's records on a sheet */
    bool grid;    /* draw altitudes and bearings over a fisheye */

    const char *format; /* as typed; NULL: by the file's name */
    struct pp_paper_choice paper;
    enum pp_orientation orientation;
    double dpi; /* 0: not given */
    const char *from_picture;
};

/* Default options; pp_render_choice_clear frees them. */
struct pp_render_choice pp_render_choice_default(void);
void pp_render_choice_clear(struct pp_render_choice *choice);

/* Checks that the options are consistent for `file_count` room files. Sets the samples
 * and the options of the cache. */
enum pp_status pp_render_choice_check(struct pp_render_choice *choice,
                                      const struct pp_room_options *options,
                                      int file_count, struct pp_error *err);

/* Chooses the format by --format, or else by the ending of the output's name (NULL:
 * standard output). */
enum pp_status pp_render_choice_format(struct pp_picture_format *format,
                                       const struct pp_render_choice *choice,
                                       const char *path, struct pp_error *err);

/* True if the picture is placed on a sheet, false if it is written pixel for pixel. */
bool pp_render_choice_on_sheet(const struct pp_render_choice *choice,
                               const struct pp_picture_format *format);

#endif
