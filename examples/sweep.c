/* sweep.c - the average daylight factor as a function of the window's width: the same
 * room with ten widths, by three methods, as CSV.
 *
 *     cc sweep.c -o sweep $(pkg-config --cflags --libs pepperpot)
 *     ./sweep > widths.csv
 */
#include <pepperpot.h>
#include <stdio.h>
#include <string.h>

static const char room[] =
    "<room version='1'>\n"
    "  <plan width='4.3' depth='6.1' height='2.9'/>\n"
    "  <finishes floor='0.25' walls='0.6' ceiling='0.8'/>\n"
    "  <window wall='south' left='%.2f' sill='0.9' width='%.2f' height='1.6'\n"
    "          glazing='clear-double' frame-factor='0.8'/>\n"
    "</room>\n";

static const char *const methods[] = {"exact+bre", "exact+split-flux", "average-df"};

/* Calculates the averages over the working plane for one width (m); false after a
 * failure, which is reported. */
static bool average(double width_m, double values[3])
{
    char text[1024];
    struct pp_building *building = NULL;
    struct pp_study *study = NULL;
    struct pp_error err;
    struct pp_mistakes *mistakes = pp_mistakes_create("sweep");
    snprintf(text, sizeof text, room, (4.3 - width_m) / 2, width_m);
    bool good =
        pp_building_parse(&building, text, strlen(text), mistakes, &err) == PP_OK
        && pp_study_create(&study, building, 0, NULL, mistakes, &err) == PP_OK
        && pp_study_methods(study, "exact+bre,exact+split-flux,average-df", false, &err)
               == PP_OK;
    for (int i = 0; good && i < 3; i++) {
        int column = pp_study_find(study, PP_DF, methods[i]);
        values[i] = pp_study_reading(study, column, -1).value;
    }
    if (!good)
        fprintf(stderr, "%s\n", err.message);
    pp_study_destroy(study);
    pp_building_destroy(building);
    pp_mistakes_destroy(mistakes);
    return good;
}

int main(void)
{
    printf("width_m,%s,%s,%s\n", methods[0], methods[1], methods[2]);
    for (int i = 1; i <= 10; i++) {
        double width_m = 0.4 * i, values[3];
        if (!average(width_m, values))
            return 1;
        printf("%.1f,%.5f,%.5f,%.5f\n", width_m, values[0], values[1], values[2]);
    }
    return 0;
}
