/* fuzz_gbxml.c - a gbXML file with any bytes is imported, or rejected with a reason.
 *
 * For clang's libFuzzer (make fuzz). The sanitizers find invalid accesses and leaks.
 * Every room file written must also be valid.
 */
#include <stdint.h>
#include <stdlib.h>

#include "formats/gbxml/gbxml_import.h"
#include "model/room/building.h"
#include "tests/fuzz/must.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_mistakes notes, mistakes;
    struct pp_error err = {PP_OK, ""};
    char *xml = NULL;
    size_t xml_length = 0;
    pp_mistakes_init(&notes, "fuzz.xml");
    pp_mistakes_init(&mistakes, "room.xml");

    enum pp_status status = pp_gbxml_import(&xml, &xml_length, (const char *)bytes,
                                            length, "fuzz.xml", &notes, &err);
    must((status == PP_OK) == (xml != NULL));
    must(status == PP_OK || err.message[0] != '\0');
    if (xml) {
        struct pp_building *building = NULL;
        must(pp_building_parse(&building, xml, xml_length, &mistakes, &err) == PP_OK);
        pp_building_destroy(building);
    }
    free(xml);
    pp_mistakes_clear(&notes);
    pp_mistakes_clear(&mistakes);
    return 0;
}
