/* make_rooflight_tables.c - makes the simplified tables of rooflights: `make tables`
 * writes tables/brs_rooflight_0.csv, _30 and _60. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "methods/protractor/protractor_scale.h"
#include "model/geometry/gauss.h"

static const double rows[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6,  0.7,     0.8, 0.9,
                              1.0, 1.2, 1.4, 1.6, 1.8, 2.0,  2.3,     2.6, 3.0,
                              3.5, 4.0, 5.0, 6.0, 8.0, 10.0, INFINITY};
static const double columns[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0,
                                 1.2, 1.4, 1.6, 1.8, 2.0, 2.5, 3.0, 4.0, 6.0, INFINITY};
enum {
    ROWS = sizeof rows / sizeof *rows,
    COLUMNS = sizeof columns / sizeof *columns,
    NODES = 40, /* Gauss nodes between two rows, and across */
};

/* Altitude, in section, of an edge at s up the slope. s is in units of the point's
 * distance from the plane of the glass. It is measured from the line where that plane
 * meets the level of the point; for horizontal glass, from above the point. */
static double altitude(double s, double slope)
{
    double b = slope > 0.0 ? s - 1.0 / tan(slope) : s;
    if (isinf(s))
        return PP_PI - slope;
    return atan2(b * sin(slope) + cos(slope), sin(slope) - b * cos(slope));
}

/* Light between two altitudes, up to the lateral distance w on one side of the
 * section. */
static double strip(const struct pp_protractor *glass, const double *nodes,
                    const double *weights, double from, double to, double w)
{
    double sum = 0.0;
    for (int i = 0; i < NODES; i++) {
        double gamma = from + (to - from) * (nodes[i] + 1.0) / 2.0;
        double last = isinf(w) ? PP_PI / 2.0 : atan(w * sin(gamma + glass->slope_rad));
        for (int k = 0; k < NODES; k++)
            sum += weights[i] * (to - from) / 2.0 * weights[k] * last / 2.0
                   * pp_protractor_scale_density(glass, gamma,
                                                 last * (nodes[k] + 1.0) / 2.0);
    }
    return sum;
}

static void write_head(FILE *out, int slope_deg)
{
    fprintf(
        out,
        "# brs_rooflight_%d.csv - simplified daylight table of rooflights, %d degrees "
        "to "
        "the horizontal\n"
        "# source: worked out for this program by quadrature "
        "(bench/make_rooflight_tables.c; make tables), in the\n"
        "#   manner of [HLG58]; that has tables of its own for rooflights, which could "
        "not be had\n"
        "# sky component (per cent) of a rectangular rooflight of clear single glass "
        "(normal transmittance 0.900) under\n"
        "#   the CIE overcast sky, at a point that faces up, d from the plane of the "
        "glass, square to it\n",
        slope_deg, slope_deg);
    if (slope_deg == 0)
        fputs("# rows: l/d, length to one side of the point over d\n", out);
    else
        fputs("# rows: s/d, up the slope from where the plane of the glass meets the "
              "point's level, over d\n",
              out);
    fputs("# columns: w/d, width to one side of the point over d\n", out);
    fputs(slope_deg == 0 ? "l_over_d" : "s_over_d", out);
    for (int k = 0; k < COLUMNS; k++)
        fprintf(out, ",%g", columns[k]);
    fputc('\n', out);
}

static void write_table(FILE *out, int slope_deg)
{
    static double cells[ROWS][COLUMNS];
    double nodes[NODES], weights[NODES];
    struct pp_protractor glass = {.sky = pp_sky_overcast(),
                                  .glass = pp_glass_clear_single(),
                                  .slope_rad = slope_deg * PP_RAD};
    pp_gauss_legendre(nodes, weights, NODES);
    write_head(out, slope_deg);
    double from = slope_deg ? 0.0 : PP_PI / 2.0;
    for (int i = 0; i < ROWS; i++) {
        double to = altitude(rows[i], glass.slope_rad);
        for (int k = 0; k < COLUMNS; k++)
            cells[i][k] = (i ? cells[i - 1][k] : 0.0)
                          + strip(&glass, nodes, weights, from, to, columns[k]);
        from = to;
    }
    for (int i = ROWS - 1; i >= 0; i--) {
        fprintf(out, "%g", rows[i]);
        for (int k = 0; k < COLUMNS; k++)
            fprintf(out, ",%.2f", 100.0 * cells[i][k]);
        fputc('\n', out);
    }
}

int main(int argc, char **argv)
{
    static const int slopes_deg[] = {0, 30, 60};
    for (int i = 0; i < 3; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/brs_rooflight_%d.csv", argc > 1 ? argv[1] : ".",
                 slopes_deg[i]);
        FILE *out = fopen(path, "w");
        if (!out) {
            perror(path);
            return 3;
        }
        write_table(out, slopes_deg[i]);
        if (fclose(out) != 0) {
            perror(path);
            return 3;
        }
    }
    return 0;
}
