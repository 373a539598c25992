/* fuzz_values.c - a CSV file of another program's values with any bytes is read, or
 * rejected with a reason; all values read are finite and not negative.
 *
 * For clang's libFuzzer (make fuzz).
 */
#include <math.h>

#include "cli/compare/other_values.h"
#include "tests/fuzz/must.h"
#include "tests/fuzz/whole_file.h"

/* Replaces the function that places the values in a room, which is not tested here. */
void pp_study_room_set_points(struct pp_study_room *room, struct pp_receiver *receivers,
                              int count)
{
    (void)room, (void)receivers, (void)count;
    abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_other_values values;
    struct pp_error err = {PP_OK, ""};
    fuzzed = bytes;
    fuzzed_length = length;
    enum pp_status status = pp_other_values_read(&values, "fuzz.csv", &err);
    must(status == PP_OK || err.message[0] != '\0');
    if (status != PP_OK)
        return 0;
    must(values.count > 0);
    for (int i = 0; i < values.count; i++)
        must(isfinite(values.list[i].value) && values.list[i].value >= 0.0
             && values.list[i].line > 0);
    pp_other_values_clear(&values);
    return 0;
}
