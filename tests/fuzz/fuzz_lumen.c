/* fuzz_lumen.c - a file of lumen tables with any bytes is read, or rejected with a line
 * and a reason.
 *
 * For clang's libFuzzer (make fuzz).
 */
#include <stdint.h>

#include "methods/lumen/lumen_csv.h"
#include "tests/fuzz/must.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_lumen_table *table = NULL;
    struct pp_mistakes mistakes;
    struct pp_error err = {PP_OK, ""};
    pp_mistakes_init(&mistakes, "fuzz.csv");
    must(pp_lumen_table_create(&table, &err) == PP_OK);
    enum pp_status status =
        pp_lumen_csv_parse(table, (const char *)bytes, length, &mistakes, &err);
    must((status == PP_BAD_INPUT) == (mistakes.count > 0 || mistakes.truncated)
         || err.message[0] != '\0');
    for (int i = 0; i < mistakes.count; i++)
        must(mistakes.list[i].line >= 0 && mistakes.list[i].text[0] != '\0');
    pp_lumen_table_destroy(table);
    pp_mistakes_clear(&mistakes);
    return 0;
}
