/* fuzz_options.c - options shared by all commands on a room, one per line, with any
 * bytes, are read, or rejected with a reason; a sky that is accepted is valid.
 *
 * For clang's libFuzzer (make fuzz).
 */
#include <math.h>
#include <string.h>

#include "cli/room_options.h"
#include "model/room/building.h"
#include "studies/criteria/grid/plane_grid.h"
#include "studies/section_line.h"
#include "tests/fuzz/must.h"

struct words {
    struct pp_room_options room;
    struct pp_project project;
    struct pp_section_place cut;
    struct pp_grid_choice grid;
    double french_m;
};

#define AT(member) offsetof(struct words, member)

static const struct pp_option_group groups[] = {
    PP_ROOM_CHOICE_GROUPS("Room", AT(room)),
    PP_ROOM_SIMULATION_GROUPS(AT(room)),
    {"Room", pp_room_external_option, AT(room)},
    {"Room", pp_room_french_option, AT(french_m)},
    {"Room", pp_room_spacing_option, AT(grid)},
    {"Room", pp_room_cut_option, AT(cut)},
    {"Room", pp_room_project_options, AT(project)},
    {"Output", pp_room_output_options, AT(room)},
    {0}};

/* Sets the sky of a room to the text of --sky, unless this is the name of a file. */
static void set_sky(const char *text)
{
    static const char xml[] =
        "<room version='1'><plan width='3' depth='4' height='2.7'/></room>";
    struct pp_building *building = NULL;
    struct pp_mistakes mistakes;
    struct pp_error err = {PP_OK, ""};
    if (strncmp(text, "picture", 7) == 0)
        return;
    pp_mistakes_init(&mistakes, "fuzz.xml");
    must(pp_building_parse(&building, xml, sizeof xml - 1, &mistakes, &err) == PP_OK);
    enum pp_status status = pp_room_set_sky(pp_building_room(building, 0), text, &err);
    must(status == PP_OK || err.message[0] != '\0');
    pp_mistakes_clear(&mistakes);
    pp_building_destroy(building);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    enum { WORDS_MOST = 24 };
    struct words values = {.room = pp_room_options_none};
    const struct pp_command_line line = {.command = "try",
                                         .operands = "FILE",
                                         .about = "Tries.",
                                         .groups = groups,
                                         .values = &values};
    char *argv[WORDS_MOST + 1] = {"try"}, *text = strndup((const char *)bytes, length);
    int count = 1, operands = 0;
    bool help = false;
    struct pp_error err = {PP_OK, ""};
    must(text != NULL);
    for (char *rest = text, *word; count < WORDS_MOST && (word = strsep(&rest, "\n"));)
        argv[count++] = word;
    enum pp_status status = pp_options_read(&line, count, argv, &operands, &help, &err);
    must(status == PP_OK ? operands < count : err.message[0] != '\0');
    if (status == PP_OK && !help)
        status = pp_room_options_settle(&values.room, &err);
    must(status == PP_OK || err.message[0] != '\0');
    if (status == PP_OK && values.room.study.sky)
        set_sky(values.room.study.sky);
    must(isfinite(values.room.study.error) && isfinite(values.room.study.seconds));
    pp_room_options_clear(&values.room);
    free(text);
    return 0;
}
