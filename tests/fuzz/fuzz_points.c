/* fuzz_points.c - sensor points (--points) with any bytes are read, or rejected with
 * the expected form; all points read are finite, except for a missing height.
 *
 * For clang's libFuzzer (make fuzz).
 */
#include <math.h>
#include <string.h>

#include "cli/room_options.h"
#include "tests/fuzz/must.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_room_options options = pp_room_options_none;
    struct pp_point_list *points = &options.study.points;
    struct pp_error err = {PP_OK, ""};
    char *text = strndup((const char *)bytes, length);
    must(text != NULL);
    enum pp_status status = pp_room_points_option[0].read(text, points, &err);
    must(status == PP_OK ? points->count > 0 : err.message[0] != '\0');
    for (int i = 0; i < points->count; i++) {
        struct pp_vec3 point = points->list[i];
        must(fabs(point.x) <= 1e6 && fabs(point.y) <= 1e6
             && (isnan(point.z) || fabs(point.z) <= 1e6));
    }
    pp_room_options_clear(&options);
    free(text);
    return 0;
}
