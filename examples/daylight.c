/* daylight.c - a room's daylight factors by hand methods and by simulation, side by
 * side.
 *
 *     cc daylight.c -o daylight $(pkg-config --cflags --libs pepperpot)
 *     ./daylight deep-office.xml
 */
#include <pepperpot.h>
#include <stdio.h>

int main(int argc, char **argv)
{
    const char *path = argc > 1 ? argv[1] : "-";
    struct pp_mistakes *mistakes = pp_mistakes_create(path);
    struct pp_building *building = NULL;
    struct pp_study *study = NULL;
    struct pp_error err;
    enum pp_status status = pp_building_read(&building, path, mistakes, &err);
    if (status == PP_OK)
        status = pp_study_create(&study, building, 0, NULL, mistakes, &err);
    if (status == PP_OK)
        status = pp_study_methods(study, "exact+bre", false, &err);
    if (status == PP_OK)
        status = pp_study_simulate(study, NULL, &err);
    while (status == PP_OK && !pp_study_done(study))
        status = pp_study_advance(study, 0.1, &err);
    for (int i = 0; i < pp_mistakes_count(mistakes); i++)
        fprintf(stderr, "%s:%d: %s\n", path, pp_mistakes_line(mistakes, i),
                pp_mistakes_text(mistakes, i));
    if (status != PP_OK)
        fprintf(stderr, "%s\n", err.message);
    for (int i = 0; status == PP_OK && i < pp_study_point_count(study); i++) {
        struct pp_reading hand =
            pp_study_reading(study, pp_study_find(study, PP_DF, "exact+bre"), i);
        struct pp_reading traced =
            pp_study_reading(study, pp_study_find(study, PP_DF, "traced"), i);
        double xyz[3];
        pp_study_point(study, i, xyz);
        printf("%5.2f %5.2f  by hand %6.2f %%  traced %6.2f +- %.2f %%\n", xyz[0],
               xyz[1], 100 * hand.value, 100 * traced.value, 100 * traced.std_error);
    }
    pp_study_destroy(study);
    pp_building_destroy(building);
    pp_mistakes_destroy(mistakes);
    return status == PP_OK ? 0 : 1;
}
