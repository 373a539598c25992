/* finding.c - compares figures with their bounds, and lists findings. */
#include "studies/criteria/finding.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/base/text.h"

/* Relative difference that is attributed to rounding when a figure is compared with its
 * bound. */
static const double rounding = 1e-9;

static bool is_met(const struct pp_finding *finding)
{
    double slack = rounding * fabs(finding->wanted);
    return finding->at_most ? finding->figure <= finding->wanted + slack
                            : finding->figure >= finding->wanted - slack;
}

struct pp_finding pp_finding_of(enum pp_figure kind, double figure, double wanted,
                                bool at_most, const char *what, ...)
{
    struct pp_finding finding = {.kind = kind,
                                 .figure = figure,
                                 .now = NAN,
                                 .before = NAN,
                                 .now_unshaded = NAN,
                                 .before_unshaded = NAN,
                                 .std_error = NAN,
                                 .grid_error = NAN,
                                 .band = pp_band_none(),
                                 .wanted = wanted,
                                 .at_most = at_most,
                                 .reached_over = NAN,
                                 .over_error = NAN,
                                 .confidence = NAN};
    finding.verdict = isnan(figure)      ? PP_NOT_JUDGED
                      : isnan(wanted)    ? PP_STATED
                      : is_met(&finding) ? PP_MET
                                         : PP_NOT_MET;
    va_list arguments;
    va_start(arguments, what);
    vsnprintf(finding.what, sizeof finding.what, what, arguments);
    va_end(arguments);
    return finding;
}

void pp_finding_compares(struct pp_finding *finding, enum pp_figure compared,
                         double now, double before)
{
    finding->compared = compared;
    finding->now = now;
    finding->before = before;
}

struct pp_finding pp_finding_not_judged(const char *why, const char *what, ...)
{
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_RATIO, NAN, NAN, false, "%s", "");
    snprintf(finding.note, sizeof finding.note, "%s", why);
    va_list arguments;
    va_start(arguments, what);
    vsnprintf(finding.what, sizeof finding.what, what, arguments);
    va_end(arguments);
    return finding;
}

const char *pp_finding_verdict(enum pp_verdict verdict)
{
    static const char *const words[] = {[PP_STATED] = NULL,
                                        [PP_MET] = "met",
                                        [PP_NOT_MET] = "not met",
                                        [PP_UNDECIDED] = "undecided",
                                        [PP_NOT_JUDGED] = "not judged"};
    return words[verdict];
}

const char *pp_finding_word(enum pp_verdict verdict)
{
    return verdict == PP_NOT_JUDGED ? "not applicable" : pp_finding_verdict(verdict);
}

const char *pp_finding_own_word(const struct pp_finding *finding)
{
    if (finding->is_optional && finding->verdict == PP_MET)
        return "reached";
    if (finding->is_optional && finding->verdict == PP_NOT_MET)
        return "not reached";
    return pp_finding_word(finding->verdict);
}

void pp_finding_within(struct pp_finding *finding, double error)
{
    bool judged = finding->verdict == PP_MET || finding->verdict == PP_NOT_MET;
    if (judged && fabs(finding->figure - finding->wanted) < error)
        finding->verdict = PP_UNDECIDED;
}

void pp_finding_sampled(struct pp_finding *finding, double std_error,
                        double probability)
{
    finding->std_error = std_error;
    if (finding->verdict != PP_MET && finding->verdict != PP_NOT_MET)
        return;
    if (probability >= PP_SURE) {
        finding->verdict = PP_MET;
        finding->confidence = probability;
    } else if (probability <= 1.0 - PP_SURE) {
        finding->verdict = PP_NOT_MET;
        finding->confidence = 1.0 - probability;
    } else {
        finding->verdict = PP_UNDECIDED;
        finding->confidence = probability;
    }
}

double pp_finding_probability_at_least(double value, double std_error, double wanted)
{
    return 0.5 * erfc((wanted - value) / (M_SQRT2 * std_error));
}

bool pp_finding_is_open(const struct pp_finding *finding)
{
    return pp_band_is_known(finding->band)
           && finding->wanted > fmin(finding->band.low, finding->figure)
           && finding->wanted < fmax(finding->band.high, finding->figure);
}

void pp_finding_by_hand(struct pp_finding *finding, struct pp_band_ends band)
{
    finding->band = band;
    if (!pp_finding_is_open(finding))
        return;
    finding->verdict = PP_UNDECIDED;
    pp_finding_note(finding, "the true value may be on the other side of the limit, so "
                             "hand figures cannot decide");
}

void pp_finding_note(struct pp_finding *finding, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    pp_text_append_v(finding->note, sizeof finding->note, format, arguments);
    va_end(arguments);
}

enum pp_status pp_finding_list_add(struct pp_finding_list *findings,
                                   const struct pp_finding *finding,
                                   struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&findings->list, findings->count, sizeof *findings->list, err);
    if (status == PP_OK)
        findings->list[findings->count++] = *finding;
    return status;
}

void pp_finding_list_add_basis(struct pp_finding_list *findings, const char *format,
                               ...)
{
    va_list arguments;
    va_start(arguments, format);
    pp_text_append_v(findings->basis, sizeof findings->basis, format, arguments);
    va_end(arguments);
}

void pp_finding_list_clear(struct pp_finding_list *findings)
{
    free(findings->list);
    *findings = (struct pp_finding_list){0};
}
