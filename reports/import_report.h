/* import_report.h - prints an imported scene and the readings of its sensors. */
#ifndef PP_REPORTS_IMPORT_REPORT_H
#define PP_REPORTS_IMPORT_REPORT_H

#include "reports/parts/format.h"
#include "formats/radiance/read/rad_read.h"
#include "simulate/transport/sensors.h"

struct pp_imported {
    char *const *files;
    int file_count;
    const struct pp_scene_description *scene;
    struct pp_rad_summary summary;
    struct pp_rgb horizontal; /* irradiance of the open horizontal ground */

    const struct pp_sensor *points;
    const struct pp_sensor_reading *readings; /* NULL: none requested */
    int count;
    bool finished, by_clock;
    bool summarised; /* true if the summary is requested */
};

/* Luminous efficacy used for illuminances, lm/W [WS98]. */
#define PP_IMPORT_EFFICACY 179.0

enum pp_status pp_import_report(const struct pp_imported *imported,
                                enum pp_format format, int width, bool utf8, FILE *out,
                                struct pp_error *err);

#endif
