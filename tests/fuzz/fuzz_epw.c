/* fuzz_epw.c - a weather file with any bytes is read safely, and so is the light
 * calculated from it.
 *
 * For clang's libFuzzer (make fuzz). The sanitizers report errors. A file must also be
 * rejected with a reason, or accepted; then its light is finite and not negative, and
 * its curve decreases.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "studies/climate/diffuse_curve.h"
#include "formats/epw/epw.h"
#include "tests/fuzz/must.h"

static void follow(const struct pp_epw *epw)
{
    static const struct pp_working_hours hours = {8.5, 17.0, 0x1F};
    const struct pp_summer_time summer = {epw->summer_from, epw->summer_to};
    struct pp_error err = {PP_OK, ""};
    struct pp_diffuse_light light;
    enum pp_status status = pp_diffuse_light_of_epw(&light, epw, "fuzz.epw", &err);
    must(status == PP_OK || err.message[0] != '\0');
    if (status != PP_OK)
        return;
    must(light.count == epw->record_count);
    for (int i = 0; i < light.count; i++)
        must(isnan(light.list[i].lx)
             || (light.list[i].lx >= 0.0 && light.list[i].lx < 1e6));

    struct pp_diffuse_curve curve;
    status = pp_diffuse_curve_init(&curve, &light, &hours, &summer, &err);
    must(status == PP_OK || err.message[0] != '\0');
    for (int i = 1; status == PP_OK && i < curve.count; i++)
        must(curve.lx[i] < curve.lx[i - 1]
             && curve.reached_h[i] > curve.reached_h[i - 1]);
    pp_diffuse_curve_clear(&curve);
    double median_lx;
    pp_diffuse_light_median(&median_lx, &light, NULL);
    pp_diffuse_light_clear(&light);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_mistakes mistakes;
    struct pp_error err = {PP_OK, ""};
    struct pp_epw *epw = NULL;
    pp_mistakes_init(&mistakes, "fuzz.epw");
    enum pp_status status =
        pp_epw_parse(&epw, (const char *)bytes, length, &mistakes, &err);
    must(status == PP_OK || err.message[0] != '\0');
    must((status == PP_OK) == (epw != NULL));
    must((status == PP_BAD_INPUT) == (mistakes.count > 0 || mistakes.truncated));
    for (int i = 0; i < mistakes.count; i++)
        must(mistakes.list[i].line >= 0 && mistakes.list[i].text[0] != '\0');
    if (epw)
        follow(epw);
    pp_epw_destroy(epw);
    pp_mistakes_clear(&mistakes);
    return 0;
}
