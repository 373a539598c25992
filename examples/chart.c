/* chart.c - charts as files in memory: a blank Waldram diagram, and the section of a
 * room if a room file is given. Prints the size and the first bytes of each.
 *
 *     cc chart.c -o chart $(pkg-config --cflags --libs pepperpot)
 *     ./chart deep-office.xml
 */
#include <pepperpot.h>
#include <stdio.h>

static bool draw(const struct pp_study *study, const char *kind)
{
    struct pp_chart_request request = {PP_CHART_SVG, PP_PAPER_A4, PP_AS_FITS, 0,
                                       false,        NULL};
    struct pp_error err;
    char *bytes;
    size_t length;
    if (pp_study_chart(study, kind, &request, &bytes, &length, &err) != PP_OK) {
        fprintf(stderr, "%s\n", err.message);
        return false;
    }
    printf("%s: %zu bytes of %.5s\n", kind, length, bytes);
    pp_free(bytes);
    return true;
}

int main(int argc, char **argv)
{
    if (!draw(NULL, "waldram"))
        return 1;
    if (argc < 2)
        return 0;
    struct pp_mistakes *mistakes = pp_mistakes_create(argv[1]);
    struct pp_building *building = NULL;
    struct pp_study *study = NULL;
    struct pp_error err;
    bool good = pp_building_read(&building, argv[1], mistakes, &err) == PP_OK
                && pp_study_create(&study, building, 0, NULL, mistakes, &err) == PP_OK;
    if (!good)
        fprintf(stderr, "%s\n", err.message);
    good = good && draw(study, "section");
    pp_study_destroy(study);
    pp_building_destroy(building);
    pp_mistakes_destroy(mistakes);
    return good ? 0 : 1;
}
