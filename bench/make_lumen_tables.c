/* make_lumen_tables.c - makes the tables of the lumen method: `make tables` writes
 * tables/lumen_sidelight.csv and tables/lumen_toplight.csv (1 to 2 minutes). With the
 * argument "errors", measures the errors that the heads of the tables state. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/lumen/lumen_cavity.h"
#include "methods/lumen/lumen_room.h"

static const double lights[] = {0.396, 0.75, 1.0, 1.25, 1.5, 1.75, NAN};
static const double depths[] = {1, 2, 3, 4, 6, 8, 10};
static const double widths[] = {0.5, 1, 2, 3, 4, 6, 8, INFINITY};
static const double ceilings[] = {0.5, 0.7, 0.9}, walls[] = {0.3, 0.5, 0.7, 0.9};

enum {
    LIGHTS = sizeof lights / sizeof *lights,
    DEPTHS = sizeof depths / sizeof *depths,
    WIDTHS = sizeof widths / sizeof *widths,
    CEILINGS = sizeof ceilings / sizeof *ceilings,
    WALLS = sizeof walls / sizeof *walls,
};

static void check(enum pp_status status, const struct pp_error *err)
{
    if (status == PP_OK)
        return;
    fprintf(stderr, "make_lumen_tables: %s\n", err->message);
    exit(1);
}

/* Coefficients: [light][ceiling][walls][depth][width]. */
static struct pp_lumen_coefficients cu[LIGHTS][CEILINGS][WALLS][DEPTHS][WIDTHS];

static void work_out(const struct pp_sky *skies, int d, int w)
{
    struct pp_error err;
    struct pp_lumen_room *room;
    check(pp_lumen_room_create(&room, widths[w], depths[d], 1, &err), &err);
    for (int l = 0; l < LIGHTS; l++) {
        pp_lumen_room_light(room, isnan(lights[l]) ? NULL : &skies[l]);
        for (int c = 0; c < CEILINGS; c++)
            for (int k = 0; k < WALLS; k++) {
                const struct pp_lumen_finishes finishes = {ceilings[c], walls[k]};
                cu[l][c][k][d][w] = pp_lumen_room_solve(room, &finishes);
            }
    }
    pp_lumen_room_destroy(room);
}

static const char side_head[] =
    "# lumen_sidelight.csv - coefficients of utilization of the lumen method, light "
    "from "
    "the side\n"
    "# source: worked out for this program by transfer of flux "
    "(methods/lumen/lumen_room.c; "
    "make tables). The method is that of [IES84], whose\n"
    "#   own tables could not be had; these are not theirs\n"
    "# conditions: a box as deep and wide as given in window heights; the window is "
    "all "
    "of one wall, black from inside, unglazed; the working\n"
    "#   plane is its floor (reflectance 0.20, that of the cavity below it: floor "
    "0.30, "
    "walls 0.50), the window's head its ceiling\n"
    "# skies: Ev/Eh 0.396 CIE overcast; 0.75 to 1.75 ISO 15469 type 13 with the sun "
    "square to the window, high enough for that ratio: 59.5,\n"
    "#   45.7, 34.3, 24.2 and 13.5 degrees; its disc is left out. Ev/Eh empty: light "
    "from "
    "an even ground\n"
    "# error: of a mesh twice as fine, at most 0.7 % (sky) and 1.3 % (ground; 0.5 % "
    "from "
    "width 2 on); light is kept to 0.1 %; four digits are printed\n"
    "# against the recalled rows of the published tables (Ev/Eh 0.75 and ground, "
    "depths "
    "1 to 3): 11 % rms, 191 of 200 cells within 20 %; of\n"
    "#   the others 7 are of width 0.5, down to 43 % less at the back\n"
    "# Ev_over_Eh: of the open sky's illuminance on the window and on the ground\n"
    "# position_percent: of the depth from the window, on the middle line; empty: mean "
    "over the plane\n"
    "# 0.5 ... inf: width over window height\n"
    "Ev_over_Eh,ceiling_reflectance,wall_reflectance,depth_over_window_height,"
    "position_percent,0.5,1,2,3,4,6,8,inf\n";

static void write_side(FILE *out)
{
    fputs(side_head, out);
    for (int l = 0; l < LIGHTS; l++)
        for (int c = 0; c < CEILINGS; c++)
            for (int k = 0; k < WALLS; k++)
                for (int d = 0; d < DEPTHS; d++)
                    for (int p = 0; p <= PP_LUMEN_POINTS; p++) {
                        if (!isnan(lights[l]))
                            fprintf(out, "%g", lights[l]);
                        fprintf(out, ",%.2f,%.2f,%g,", ceilings[c], walls[k],
                                depths[d]);
                        if (p < PP_LUMEN_POINTS)
                            fprintf(out, "%.0f", 100.0 * pp_lumen_places[p]);
                        for (int w = 0; w < WIDTHS; w++) {
                            const struct pp_lumen_coefficients *cell =
                                &cu[l][c][k][d][w];
                            fprintf(out, ",%.4g",
                                    p < PP_LUMEN_POINTS ? cell->at[p] : cell->average);
                        }
                        fputc('\n', out);
                    }
}

static const char top_head[] =
    "# lumen_toplight.csv - coefficients of utilization of the lumen method, light "
    "from "
    "above\n"
    "# source: worked out for this program by zonal transfer of flux "
    "(methods/lumen/lumen_cavity.c; make tables); the method is that of [IES84]\n"
    "# conditions: Lambertian openings spread evenly over the ceiling; square plan; "
    "working plane of reflectance 0.20; ceiling, walls and plane\n"
    "#   each evenly bright\n"
    "# error: a plan of 2 to 1 with the same ratio has up to 1 % more, one of 4 to 1 "
    "up "
    "to 7 %; four digits are printed\n"
    "# rcr: room cavity ratio, 5 h (L + W) / (L W), h from the working plane to the "
    "ceiling\n"
    "# ceiling_reflectance: its openings' share included\n"
    "# cu: light on the working plane over light that leaves the openings\n"
    "rcr,ceiling_reflectance,wall_reflectance,cu\n";

static void write_top(FILE *out)
{
    static const double tops[] = {0.8, 0.5, 0.2}, sides[] = {0.7, 0.5, 0.3, 0.1};
    fputs(top_head, out);
    for (int rcr = 0; rcr <= 10; rcr++)
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 4; k++)
                fprintf(out, "%d,%.2f,%.2f,%.4f\n", rcr, tops[c], sides[k],
                        pp_lumen_cavity(rcr, tops[c], sides[k], PP_LUMEN_PLANE));
}

/* Largest change of any coefficient with a mesh twice as fine, and largest loss of
 * light, over a sample of rooms. */
static void errors(const struct pp_sky *skies)
{
    static const struct pp_lumen_finishes finishes = {0.7, 0.5};
    struct pp_error err;
    for (int l = 0; l < LIGHTS; l += l ? 3 : 1)
        for (int w = 0; w < WIDTHS; w += 2) {
            double worst = 0.0, lost = 0.0;
            for (int d = 0; d < DEPTHS; d += 3) {
                struct pp_lumen_coefficients got[2];
                for (int fine = 1; fine <= 2; fine++) {
                    struct pp_lumen_room *room;
                    check(pp_lumen_room_create(&room, widths[w], depths[d], fine, &err),
                          &err);
                    pp_lumen_room_light(room, isnan(lights[l]) ? NULL : &skies[l]);
                    got[fine - 1] = pp_lumen_room_solve(room, &finishes);
                    lost = fmax(lost, fabs(pp_lumen_room_imbalance(room)));
                    pp_lumen_room_destroy(room);
                }
                for (int p = 0; p < PP_LUMEN_POINTS; p++)
                    worst = fmax(worst, fabs(got[0].at[p] / got[1].at[p] - 1.0));
                worst = fmax(worst, fabs(got[0].average / got[1].average - 1.0));
            }
            printf("Ev/Eh %g, width %g: changes by up to %.2f %%, loses %.2f %%\n",
                   lights[l], widths[w], 100.0 * worst, 100.0 * lost);
        }
}

static FILE *open_table(const char *folder, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *out = fopen(path, "w");
    if (!out) {
        perror(path);
        exit(1);
    }
    return out;
}

static void close_table(FILE *out)
{
    if (ferror(out) | fclose(out)) {
        fputs("make_lumen_tables: writing failed\n", stderr);
        exit(1);
    }
}

int main(int argc, char **argv)
{
    struct pp_sky skies[LIGHTS];
    struct pp_error err;
    if (argc != 2) {
        fputs("expected the folder to write to, or \"errors\"\n", stderr);
        return 2;
    }
    for (int l = 0; l < LIGHTS - 1; l++)
        check(pp_lumen_room_sky(&skies[l], lights[l], &err), &err);
    if (strcmp(argv[1], "errors") == 0) {
        errors(skies);
        return 0;
    }
    for (int d = 0; d < DEPTHS; d++)
        for (int w = 0; w < WIDTHS; w++)
            work_out(skies, d, w);
    FILE *out = open_table(argv[1], "lumen_sidelight.csv");
    write_side(out);
    close_table(out);
    out = open_table(argv[1], "lumen_toplight.csv");
    write_top(out);
    close_table(out);
    return 0;
}
