/* validate_page.c - the verdict, a table of the groups with their histograms, and all
 * cases, folded away. */
#include "reports/validate/validate_page.h"

#include <math.h>
#include <string.h>

#include "config.h"
#include "reports/page/html.h"

/* Bins of difference over limit, from -1.5 to 1.5; what is beyond stands in the last. */
enum { BINS = 31 };

static const double BIN_MOST = 1.5;

/* Of a histogram, in pixels. */
enum { BIN_WIDTH = 6, BAR_HEIGHT = 40, AXIS_HEIGHT = 14 };

/* The cases of one group, which need not stand together. */
struct group {
    const char *name;
    int count, wrong;
    double worst;   /* |difference| over limit */
    double squares; /* of differences */
    int bins[BINS];
};

/* Beside that of all pages (html.h). */
static const char more_style[] =
    ".verdict.bad{border-color:var(--bad)}\n"
    "td:first-child,th:first-child{text-align:left;white-space:normal}\n"
    "svg{display:block}rect.in{fill:var(--good)}rect.out{fill:var(--bad)}"
    "line{stroke:var(--soft)}text{fill:var(--soft);font:10px system-ui,sans-serif}\n"
    "details{margin:.4rem 0}summary{cursor:pointer}\n"
    "@media print{body{max-width:none;padding:0}.cases{display:none}tr{break-inside:"
    "avoid}}\n";

/* ---- groups ---- */

static int find_group(struct group *groups, int count, const char *name)
{
    int i = 0;
    while (i < count && strcmp(groups[i].name, name) != 0)
        i++;
    return i;
}

static void count_case(struct group *group, const struct pp_known_case *one)
{
    double difference = one->answer - one->expected;
    double share = one->limit > 0.0 ? difference / one->limit : 0.0;
    double place = floor((share / BIN_MOST + 1.0) / 2.0 * BINS);
    group->count++;
    group->wrong += !pp_known_case_is_right(one);
    group->squares += difference * difference;
    if (isfinite(place)) {
        group->worst = fmax(group->worst, fabs(share));
        group->bins[(int)fmin(fmax(place, 0.0), BINS - 1.0)]++;
    }
}

/* The first groups, up to GROUPS_MOST, which is more than any suite has; their number. */
enum { GROUPS_MOST = 64 };

static int gather(struct group groups[GROUPS_MOST], const struct pp_known_cases *cases)
{
    int count = 0;
    for (int i = 0; i < cases->count; i++) {
        int at = find_group(groups, count, cases->list[i].group);
        if (at == GROUPS_MOST)
            continue;
        if (at == count)
            groups[count++] = (struct group){.name = cases->list[i].group};
        count_case(&groups[at], &cases->list[i]);
    }
    return count;
}

static void put_histogram(const struct group *group, FILE *out)
{
    const int width = BINS * BIN_WIDTH;
    int most = 1;
    for (int i = 0; i < BINS; i++)
        most = group->bins[i] > most ? group->bins[i] : most;
    fprintf(out,
            "<svg width=\"%d\" height=\"%d\" role=\"img\" aria-label=\"histogram of "
            "difference over limit\">",
            width, BAR_HEIGHT + AXIS_HEIGHT);
    for (int i = 0; i < BINS; i++) {
        double middle = ((i + 0.5) / BINS * 2.0 - 1.0) * BIN_MOST;
        double height = (double)BAR_HEIGHT * group->bins[i] / most;
        if (group->bins[i] > 0)
            fprintf(out,
                    "<rect class=\"%s\" x=\"%d\" y=\"%.1f\" width=\"%d\" "
                    "height=\"%.1f\"/>",
                    fabs(middle) <= 1.0 ? "in" : "out", i * BIN_WIDTH,
                    BAR_HEIGHT - fmax(height, 1.0), BIN_WIDTH - 1, fmax(height, 1.0));
    }
    fprintf(out, "<line x1=\"0\" x2=\"%d\" y1=\"%d.5\" y2=\"%d.5\"/>", width,
            BAR_HEIGHT, BAR_HEIGHT);
    static const struct {
        double place;
        const char *text;
    } marks[] = {{-1.0, "&minus;1"}, {0.0, "0"}, {1.0, "+1"}};
    for (int i = 0; i < 3; i++) {
        double x = (marks[i].place / BIN_MOST + 1.0) / 2.0 * width;
        fprintf(out,
                "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%d\"/><text x=\"%.1f\" "
                "y=\"%d\" text-anchor=\"middle\">%s</text>",
                x, x, BAR_HEIGHT, BAR_HEIGHT + 3, x, BAR_HEIGHT + AXIS_HEIGHT - 1,
                marks[i].text);
    }
    fputs("</svg>", out);
}

static void put_groups(const struct group *groups, int count, FILE *out)
{
    fputs(
        "<h2>How far off</h2>\n<p class=\"soft\">Differences over their limits: what "
        "lies between &minus;1 and +1 is right.</p>\n<div "
        "class=\"wide\"><table><thead><tr><th>group<th>cases<th>outside<th>RMS, share "
        "of the open sky<th>worst over limit<th>difference over limit"
        "</tr></thead>\n<tbody>\n",
        out);
    for (int i = 0; i < count; i++) {
        const struct group *group = &groups[i];
        fputs("<tr><td>", out);
        pp_html_text(group->name, out);
        fprintf(out, "<td>%d<td%s>%d<td>%.1e<td>%.2f<td>", group->count,
                group->wrong > 0 ? " class=\"bad\"" : "", group->wrong,
                sqrt(group->squares / group->count), group->worst);
        put_histogram(group, out);
        fputs("</tr>\n", out);
    }
    fputs("</tbody></table></div>\n", out);
}

/* ---- cases ---- */

static void put_case(const struct pp_known_case *one, FILE *out)
{
    bool right = pp_known_case_is_right(one);
    fputs("<tr><td>", out);
    pp_html_text(one->what, out);
    fputs("<td>", out);
    pp_html_text(one->by, out);
    fprintf(out, "<td>%.6f<td>%.6f<td>%+.1e<td>%.1e<td%s>%s</tr>\n", one->answer,
            one->expected, one->answer - one->expected, one->limit,
            right ? "" : " class=\"bad\"", right ? "right" : "outside");
}

static void put_cases(const struct pp_known_cases *cases, const char *group,
                      bool wrong_only, FILE *out)
{
    fputs("<div class=\"wide\"><table><thead><tr><th>case<th>by<th>answer<th>expected"
          "<th>difference<th>limit<th></tr></thead>\n<tbody>\n",
          out);
    for (int i = 0; i < cases->count; i++) {
        const struct pp_known_case *one = &cases->list[i];
        if ((!group || strcmp(group, one->group) == 0)
            && !(wrong_only && pp_known_case_is_right(one)))
            put_case(one, out);
    }
    fputs("</tbody></table></div>\n", out);
}

static void put_verdict(const struct pp_known_result *result, FILE *out)
{
    struct pp_suite_score score = pp_suite_score(result->suite, &result->cases);
    int wrong = score.wrong + score.traced_wrong;
    fprintf(
        out,
        "<p class=\"verdict%s\">%s: %d of %d answers are within their limits.</p>\n",
        score.passes ? "" : " bad", score.passes ? "Passed" : "Not passed",
        result->cases.count - wrong, result->cases.count);
    fputs("<p>Limits: ", out);
    pp_html_text(result->suite->limits, out);
    fputs(".</p>\n", out);
    if (score.traced == 0)
        return;
    fprintf(out, "<p>%d answers are simulated, %d of them outside", score.traced,
            score.traced_wrong);
    if (result->suite->chance > 0.0)
        fprintf(out, "; chance may put %.0f there",
                floor(result->suite->chance * score.traced));
    fputs(".</p>\n", out);
}

void pp_validate_page(const struct pp_known_result *result, FILE *out)
{
    const struct pp_known_cases *cases = &result->cases;
    struct pp_suite_score score = pp_suite_score(result->suite, cases);
    struct group groups[GROUPS_MOST];
    int count = gather(groups, cases);
    char title[128];
    snprintf(title, sizeof title, PACKAGE_NAME " validate %s", result->suite->name);
    pp_html_begin(title, more_style, out);
    fputs("<h1>" PACKAGE_NAME " against what is known</h1>\n<p class=\"soft\">", out);
    pp_html_text(result->suite->name, out);
    fputs(": ", out);
    pp_html_text(result->suite->summary, out);
    fputs(". Figures are shares of the open sky's horizontal illuminance, made "
          "by " PACKAGE_NAME " " PACKAGE_VERSION ".</p>\n",
          out);
    put_verdict(result, out);
    put_groups(groups, count, out);
    if (score.wrong + score.traced_wrong > 0) {
        fputs("<h2>Outside their limits</h2>\n", out);
        put_cases(cases, NULL, true, out);
    }
    fputs("<section class=\"cases\"><h2>All cases</h2>\n", out);
    for (int i = 0; i < count; i++) {
        fputs("<details><summary>", out);
        pp_html_text(groups[i].name, out);
        fprintf(out, ", %d</summary>\n", groups[i].count);
        put_cases(cases, groups[i].name, false, out);
        fputs("</details>\n", out);
    }
    fputs("</section>\n", out);
    pp_html_end(out);
}
