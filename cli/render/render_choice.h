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

/* Coordinates as typed: "X,Y" or "X,Y,Z". */
struct pp_coordinates {
    int count; /* number of coordinates, 2 or 3; 0: not given */
    struct pp_vec3 is;
};

enum { PP_LEVELS_MOST = 32 };

struct pp_levels {
    int count;
    double list[PP_LEVELS_MOST]; /* ascending, above 0, in the unit of the quantity */
};

struct pp_exposure {
    enum pp_tone_way way;
    double white; /* value displayed as white, given by the user, in the unit of the
                   * quantity */
    bool said;
};

struct pp_picture_size {
    int width, height; /* pixels; 0: not given */
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
    PP_WINDOWS_STORED, /* next-event estimation; light from outdoor surfaces is
                        * calculated once and stored */
    PP_WINDOWS_AIMED,  /* next-event estimation along each path */
    PP_WINDOWS_CHANCE, /* BRDF sampling only */
};

struct pp_render_choice {
    enum pp_view_choice view;
    struct pp_coordinates from, towards, direction, up;
    double angle_deg; /* angle of view; 0: not given */
    double across_m;  /* width of a parallel view; 0: not given */
    struct pp_picture_size size;

    struct pp_quantity_choice quantity;
    enum pp_pixel_filter filter;
    int samples; /* paths per pixel; 0: not given, until the options are checked */
    bool paths;  /* use light paths only, without a cache */
    enum pp_window_light windows;
    struct pp_cache_choice cache;
    const char *checkpoint;
    const char *errors; /* file for the standard errors of the pixels; NULL: none */

    struct pp_exposure exposure;
    bool false_colour;
    struct pp_levels range, levels; /* range: limits of the scale; empty or two
                                     * values */
    bool linear, no_contours;
    bool records; /* mark the records of the cache on a sheet */
    bool grid;    /* draw lines of altitude and bearing over a fisheye picture */

    const char *format; /* as typed; NULL: by the extension of the file */
    struct pp_paper_choice paper;
    enum pp_orientation orientation;
    double dpi; /* resolution of PNG; 0: not given */
    const char *from_picture;
};

/* Default options. pp_render_choice_clear frees them. */
struct pp_render_choice pp_render_choice_default(void);
void pp_render_choice_clear(struct pp_render_choice *choice);

/* Checks that the options are consistent, with `file_count` room files. Sets the number
 * of samples and the options of the cache. */
enum pp_status pp_render_choice_check(struct pp_render_choice *choice,
                                      const struct pp_room_options *options,
                                      int file_count, struct pp_error *err);

/* Determines the format from --format, or else from the extension of the output's name
 * (NULL: standard output). */
enum pp_status pp_render_choice_format(struct pp_picture_format *format,
                                       const struct pp_render_choice *choice,
                                       const char *path, struct pp_error *err);

/* True if the picture is placed on a sheet. False if its pixels are written directly to
 * a file. */
bool pp_render_choice_on_sheet(const struct pp_render_choice *choice,
                               const struct pp_picture_format *format);

#endif
