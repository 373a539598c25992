/* fuzz_atlas.c - a file of the atlas with any bytes is read, or rejected with a reason;
 * every row read has the number of a room.
 *
 * For clang's libFuzzer (make fuzz).
 */
#include "studies/research/atlas/atlas_table.h"
#include "tests/fuzz/must.h"
#include "tests/fuzz/whole_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_atlas_table table;
    struct pp_error err = {PP_OK, ""};
    fuzzed = bytes;
    fuzzed_length = length;
    enum pp_status status = pp_atlas_table_read(&table, "fuzz.csv", &err);
    must(status == PP_OK || err.message[0] != '\0');
    if (status == PP_OK) {
        must(pp_atlas_table_find(&table, "room") == table.room);
        must(pp_atlas_table_find(&table, "point") == table.point);
        for (int row = 0; row < table.row_count; row++)
            must((int)pp_atlas_table_value(&table, row, table.room) >= 0);
    }
    pp_atlas_table_clear(&table);
    return 0;
}
