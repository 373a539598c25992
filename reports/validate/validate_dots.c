/* validate_dots.c - writes the SVG of the dot charts: three rows, with one dot per case
 * in each row. */
#include "reports/validate/validate_dots.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "reports/page/html.h"

const char pp_validate_dots_style[] =
    ".dots{display:flex;flex-wrap:wrap;gap:.6rem 2rem}figure{margin:0;width:340px;"
    "max-width:100%;break-inside:avoid}figcaption{font-weight:600}figure "
    "svg{width:100%;"
    "height:auto}circle{fill:var(--good);fill-opacity:.4}circle.edge{fill:none;"
    "stroke:var(--bad)}line.median{stroke:var(--bad);stroke-width:2}\n";

/* Dimensions of a chart, in pixels. */
enum { LEFT = 66, RIGHT = 334, WIDTH = 340, ROW = 22, AXIS = 16 };

enum { ROWS = 3 };

static const char *const rows[ROWS] = {"difference", "assumption", "formula"};

/* Least expected value for which a relative difference is meaningful, as a fraction of
 * the illuminance under the open sky. */
static const double LEAST = 1e-4;

static double dots_of_case(const struct pp_known_case *one, int row)
{
    const double parts[ROWS] = {one->answer - one->expected, one->assumption,
                                one->formula};
    return parts[row] / one->expected;
}

static bool has_dots(const struct pp_known_case *one, const char *group)
{
    return strcmp(one->group, group) == 0 && one->expected >= LEAST
           && isfinite(one->assumption) && isfinite(one->formula);
}

static double share_on_axis(double share)
{
    return LEFT + (fmin(fmax(share, -1.0), 1.0) + 1.0) / 2.0 * (RIGHT - LEFT);
}

static int in_order(const void *a, const void *b)
{
    const double *first = a, *second = b;
    return (*first > *second) - (*first < *second);
}

static double median_of(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, in_order);
    return (values[(count - 1) / 2] + values[count / 2]) / 2.0;
}

/* Writes a dot. Dots of consecutive cases are at seven different heights, so that equal
 * values can be distinguished. */
static void put_dot(double share, int number, int middle, FILE *out)
{
    double y = middle + 2.0 * (number * 3 % 7 - 3);
    fprintf(out, "<circle%s cx=\"%.1f\" cy=\"%.1f\" r=\"2\"/>",
            fabs(share) > 1.0 ? " class=\"edge\"" : "", share_on_axis(share), y);
}

static void put_dots_row(const struct pp_known_cases *cases, const char *group, int row,
                         double *shares, FILE *out)
{
    int count = 0, middle = row * ROW + ROW / 2;
    fprintf(out, "<text x=\"0\" y=\"%d\">%s</text>", middle + 4, rows[row]);
    for (int i = 0; i < cases->count; i++)
        if (has_dots(&cases->list[i], group)) {
            shares[count] = dots_of_case(&cases->list[i], row);
            put_dot(shares[count], count, middle, out);
            count++;
        }
    double x = share_on_axis(median_of(shares, count));
    fprintf(out,
            "<line class=\"median\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%d\"/>\n", x,
            x, middle - ROW / 2 + 1, middle + ROW / 2 - 1);
}

static void put_axis(FILE *out)
{
    static const struct {
        double share;
        const char *text, *anchor;
    } marks[] = {{-1.0, "&minus;100", "middle"},
                 {-0.5, "&minus;50", "middle"},
                 {0.0, "0", "middle"},
                 {0.5, "+50", "middle"},
                 {1.0, "+100 %", "end"}};
    const int bottom = ROWS * ROW;
    fprintf(out, "<line x1=\"%d\" x2=\"%d\" y1=\"%d.5\" y2=\"%d.5\"/>", LEFT, RIGHT,
            bottom, bottom);
    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++) {
        double x = share_on_axis(marks[i].share);
        bool end = strcmp(marks[i].anchor, "end") == 0;
        fprintf(out,
                "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%d\"/><text x=\"%.1f\" "
                "y=\"%d\" text-anchor=\"%s\">%s</text>",
                x, x, marks[i].share == 0.0 ? 0 : bottom, bottom + 3,
                end ? (double)WIDTH : x, bottom + AXIS - 2, marks[i].anchor,
                marks[i].text);
    }
}

void pp_validate_dots(const struct pp_known_cases *cases, const char *group, FILE *out)
{
    int count = 0;
    for (int i = 0; i < cases->count; i++)
        count += has_dots(&cases->list[i], group);
    double *shares = count > 0 ? malloc((size_t)count * sizeof *shares) : NULL;
    if (!shares)
        return;
    fputs("<figure><figcaption>", out);
    pp_html_text(group, out);
    fprintf(out,
            "</figcaption><svg viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"errors "
            "in per cent: difference, assumption, formula\">\n",
            WIDTH, ROWS * ROW + AXIS);
    for (int row = 0; row < ROWS; row++)
        put_dots_row(cases, group, row, shares, out);
    put_axis(out);
    fputs("</svg></figure>\n", out);
    free(shares);
}
