/* fuzz_bsdf.c - a WINDOW XML file with any bytes is read as a measured pane, or
 * rejected with a reason.
 *
 * For clang's libFuzzer (make fuzz). The sanitizers find invalid accesses and leaks.
 * The shares of the pane must also be numbers, and samples must pass through it.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "model/light/bsdf/bsdf_file.h"
#include "model/light/bsdf/measured_pane.h"
#include "tests/fuzz/must.h"

static void check(const struct pp_measured_pane *pane)
{
    const struct pp_pane_scatter *scatter = &pane->scatter;
    must(pane->diffuse > 0.0 && isfinite(pane->diffuse));
    must(pane->normal >= 0.0); /* 0: a prism may reflect all light at this angle */
    for (int i = 0; i < 16; i++) {
        double theta = 0.1 * i, phi = i;
        struct pp_vec3 out =
            pp_vec(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
        struct pp_vec3 in;
        if (i % 2)
            out.z = -out.z;
        must(scatter->straight(pane, out) >= 0.0
             && scatter->scattered(pane, out) >= 0.0);
        if (scatter->sample(pane, out, 0.06 * i + 0.01, 0.5, &in) > 0.0)
            must(in.z * out.z >= 0.0 && fabs(pp_vec_length(in) - 1.0) < 1e-6);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_error err = {PP_OK, ""};
    struct pp_bsdf bsdf;
    char *copy = malloc(length + 1);
    if (!copy)
        return 0;
    memcpy(copy, bytes, length);
    enum pp_status status = pp_bsdf_file_parse(&bsdf, copy, length, "fuzz.xml", &err);
    must(status == PP_OK || err.message[0] != '\0');
    free(copy);
    if (status != PP_OK)
        return 0;
    struct pp_measured_pane *pane;
    status = pp_measured_pane_create(&pane, &bsdf, length % 2, &err);
    must(status == PP_OK || err.message[0] != '\0');
    if (status == PP_OK)
        check(pane);
    pp_measured_pane_release(pane);
    pp_bsdf_clear(&bsdf);
    return 0;
}
