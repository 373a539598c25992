/* validate_page.c - writes the verdict, a table of the groups with histograms, and all
 * cases, which are hidden at first. */
#include "reports/validate/validate_page.h"

#include <math.h>
#include <string.h>

#include "config.h"
#include "reports/page/html.h"
#include "reports/validate/validate_dots.h"

/* Number of histogram bins for the difference divided by its limit
 * (pp_known_case_share), from -1.5 to 1.5. Values outside are in the first and last
 * bins. */
enum { BINS = 31 };

static const double BIN_MOST = 1.5;

/* Dimensions of a histogram, in pixels. */
enum { BIN_WIDTH = 6, BAR_HEIGHT = 40, AXIS_HEIGHT = 14 };

/* A group of cases; they need not be adjacent in the list. */
struct group {
    const char *name;
    int count, wrong, unjudged;
    double worst;   /* greatest |difference| / limit */
    double squares; /* sum of the squared differences */
    int bins[BINS];
};

/* Style rules in addition to those of all pages (html.h). */
static const char more_style[] =
    ".verdict.bad{border-color:var(--bad)}\n"
    "td:first-child,th:first-child{text-align:left;white-space:normal}\n"
    "svg{display:block}rect.in{fill:var(--good)}rect.out{fill:var(--bad)}"
    "line{stroke:var(--soft)}text{fill:var(--soft);font:10px system-ui,sans-serif}\n"
    ".groups th{white-space:normal}.cases-of td:first-child{min-width:9rem}\n"
    "@media(max-width:600px){.groups "
    "th:is(:nth-child(2),:nth-child(4),:nth-child(5)),.groups "
    "td:is(:nth-child(2),:nth-child(4),:nth-child(5)){display:"
    "none}.groups svg{width:110px;height:auto}}\n"
    "details{margin:.4rem 0}summary{cursor:pointer}\n"
    "@media print{body{max-width:none;padding:0}.cases{display:none}tr{break-inside:"
    "avoid}table{font-size:.65rem}.cases-of :is(td,th){padding-right:.25rem}"
    ".cases-of td:first-child{min-width:7rem}}\n";

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
    double share = pp_known_case_share(one);
    double place = floor((share / BIN_MOST + 1.0) / 2.0 * BINS);
    group->count++;
    group->squares += difference * difference;
    if (!pp_known_case_is_judged(one)) {
        group->unjudged++;
        return;
    }
    group->wrong += !pp_known_case_is_right(one);
    if (isfinite(place)) {
        group->worst = fmax(group->worst, fabs(share));
        group->bins[(int)fmin(fmax(place, 0.0), BINS - 1.0)]++;
    }
}

/* Exceeds the number of groups in any suite. */
enum { GROUPS_MOST = 256 };

/* Collects the groups and returns their number. */
static int gather_case_groups(struct group groups[GROUPS_MOST],
                              const struct pp_known_cases *cases)
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
            "<svg width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" role=\"img\" "
            "aria-label=\"histogram of "
            "difference over limit\">",
            width, BAR_HEIGHT + AXIS_HEIGHT, width, BAR_HEIGHT + AXIS_HEIGHT);
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
    fputs("<h2>Deviations</h2>\n<p class=\"soft\">Differences divided by their limits: "
          "values between &minus;1 and +1 pass.</p>\n<div class=\"wide\"><table "
          "class=\"groups\"><thead><tr><th>group<th>cases<th>outside<th>RMS, share of "
          "the open sky<th>worst over limit<th>difference over "
          "limit</tr></thead>\n<tbody>\n",
          out);
    for (int i = 0; i < count; i++) {
        const struct group *group = &groups[i];
        fputs("<tr><td>", out);
        pp_html_text(group->name, out);
        fprintf(out, "<td>%d<td%s>%d<td>%.1e<td>", group->count,
                group->wrong > 0 ? " class=\"bad\"" : "", group->wrong,
                sqrt(group->squares / group->count));
        if (group->unjudged == group->count) {
            fputs("<td class=\"w soft\">no verdict", out);
        } else {
            fprintf(out, "%.2f<td>", group->worst);
            put_histogram(group, out);
        }
        fputs("</tr>\n", out);
    }
    fputs("</tbody></table></div>\n", out);
}

/* Writes the dot charts of the errors of methods and their two parts. */
static void put_parts(const struct group *groups, int count,
                      const struct pp_known_cases *cases, FILE *out)
{
    fputs("<h2>Causes of the differences</h2>\n<p class=\"soft\">Each dot stands for "
          "one figure. Rows show its difference from the simulation, in per cent, and "
          "the two parts of this difference. The assumption part is the difference "
          "between the room and the room that the method assumes, both simulated. The "
          "formula part is the difference between that assumed room and the method. "
          "Bars are medians; rings are values over 100 %; figures under 0.01 % "
          "daylight factor are ignored.</p>\n<div class=\"dots\">\n",
          out);
    for (int i = 0; i < count; i++)
        pp_validate_dots(cases, groups[i].name, out);
    fputs("</div>\n", out);
}

/* ---- cases ---- */

static const char *verdict_of(const struct pp_known_case *one)
{
    return !pp_known_case_is_judged(one) ? "none"
           : pp_known_case_is_right(one) ? "right"
                                         : "outside";
}

static void put_case(const struct pp_known_case *one, bool parts, FILE *out)
{
    bool right = pp_known_case_is_right(one) || !pp_known_case_is_judged(one);
    fputs("<tr><td>", out);
    pp_html_text(one->what, out);
    if (one->room) {
        fputs(", ", out);
        pp_html_text(one->room, out);
    }
    fputs("<td>", out);
    pp_html_text(one->by, out);
    fprintf(out, "<td>%.6f<td>%.6f<td>%+.1e<td>", one->answer, one->expected,
            one->answer - one->expected);
    if (!pp_known_case_is_judged(one))
        fputs("&ndash;", out);
    else if (one->least == -one->limit)
        fprintf(out, "%.1e", one->limit);
    else
        fprintf(out, "%+.1e to %+.1e", one->least, one->limit);
    if (parts)
        fprintf(out, "<td>%+.1e<td>%+.1e", one->assumption, one->formula);
    fprintf(out, "<td%s>%s</tr>\n", right ? "" : " class=\"bad\"", verdict_of(one));
}

static void put_cases(const struct pp_known_cases *cases, const char *group,
                      bool wrong_only, FILE *out)
{
    bool parts = pp_known_case_has_parts(cases);
    fprintf(out,
            "<div class=\"wide\"><table "
            "class=\"cases-of\"><thead><tr><th>case<th>by<th>answer<th>expected"
            "<th>difference<th>limit%s<th></tr></thead>\n<tbody>\n",
            parts ? "<th>assumption<th>formula" : "");
    for (int i = 0; i < cases->count; i++) {
        const struct pp_known_case *one = &cases->list[i];
        if ((!group || strcmp(group, one->group) == 0)
            && !(wrong_only
                 && (pp_known_case_is_right(one) || !pp_known_case_is_judged(one))))
            put_case(one, parts, out);
    }
    fputs("</tbody></table></div>\n", out);
}

/* Writes the reasons why cases have no verdict. Each reason is written once. */
static void put_reasons(const struct pp_known_cases *cases,
                        const struct pp_suite_score *score, FILE *out)
{
    const char *why;
    int count;
    if (score->unjudged == 0)
        return;
    fprintf(out, "<p>%d further results have no verdict:</p>\n<ul>\n", score->unjudged);
    for (int i = 0; (why = pp_known_case_reason(cases, i, &count)); i++) {
        fprintf(out, "<li>%d: ", count);
        pp_html_text(why, out);
        fputs("</li>\n", out);
    }
    fputs("</ul>\n", out);
}

static void put_verdict(const struct pp_known_result *result, FILE *out)
{
    struct pp_suite_score score = pp_suite_score(result->suite, &result->cases);
    int wrong = score.wrong + score.traced_wrong;
    fprintf(
        out,
        "<p class=\"verdict%s\">%s: %d of %d results are within their limits.</p>\n",
        score.passes ? "" : " bad", score.passes ? "Passed" : "Not passed",
        score.count + score.traced - wrong, score.count + score.traced);
    fputs("<p>Limits: ", out);
    pp_html_text(result->suite->limits, out);
    fputs(".</p>\n", out);
    put_reasons(&result->cases, &score, out);
    if (score.traced == 0)
        return;
    fprintf(out, "<p>%d results are simulated; %d of them are outside their limits",
            score.traced, score.traced_wrong);
    if (result->suite->chance > 0.0)
        fprintf(out, "; %.0f would be expected by chance",
                floor(result->suite->chance * score.traced));
    fputs(".</p>\n", out);
}

void pp_validate_page(const struct pp_known_result *result, FILE *out)
{
    const struct pp_known_cases *cases = &result->cases;
    struct pp_suite_score score = pp_suite_score(result->suite, cases);
    struct group groups[GROUPS_MOST];
    int count = gather_case_groups(groups, cases);
    char title[128], style[2000];
    snprintf(title, sizeof title, PACKAGE_NAME " validate %s", result->suite->name);
    snprintf(style, sizeof style, "%s%s", more_style, pp_validate_dots_style);
    pp_html_begin(title, style, out);
    if (result->suite->of_rooms) {
        fputs("<h1>Hand methods compared with the simulation</h1>\n<p class=\"soft\">",
              out);
    } else {
        fputs("<h1>" PACKAGE_NAME
              " compared with known values</h1>\n<p class=\"soft\">",
              out);
        pp_html_text(result->suite->name, out);
        fputs(": ", out);
    }
    pp_html_text(result->suite->summary, out);
    fputs(". Figures are shares of the open sky's horizontal illuminance, calculated "
          "by " PACKAGE_NAME " " PACKAGE_VERSION ".</p>\n",
          out);
    put_verdict(result, out);
    put_groups(groups, count, out);
    if (pp_known_case_has_parts(cases))
        put_parts(groups, count, cases, out);
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
