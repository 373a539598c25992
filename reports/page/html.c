/* html.c - see html.h. */
#include "reports/page/html.h"

#include <stdlib.h>

#include "reports/parts/format.h"

static const char style[] =
    ":root{color-scheme:light dark;--ink:#1b1f24;--soft:#5b6470;--line:#d5dae0;"
    "--paper:#fff;--good:#2f6fb0;--bad:#c02f2f;--band:#eef3f8}\n"
    "@media(prefers-color-scheme:dark){:root{--ink:#e6e9ec;--soft:#9aa4af;"
    "--line:#39424c;--paper:#14181c;--good:#6fa8dc;--bad:#ff7b72;--band:#1d252d}}\n"
    "body{margin:0 auto;max-width:60rem;padding:1.5rem 1rem 4rem;"
    "background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,sans-serif}\n"
    "h1{font-size:1.6rem;margin:0 0 .2rem}h2{font-size:1.25rem;margin:2.6rem 0 .4rem}\n"
    "h3{font-size:1rem;margin:1.4rem 0 .3rem}p{margin:.4rem 0}\n"
    ".soft{color:var(--soft)}.bad{color:var(--bad)}.good{color:var(--good)}\n"
    ".verdict{font-size:1.15rem;border-left:.3rem solid var(--good);"
    "background:var(--band);padding:.6rem .9rem;margin:1rem 0}\n"
    ".wide{overflow-x:auto}table{border-collapse:collapse;width:100%;font-size:.9rem}\n"
    "th,td{padding:.25rem .6rem .25rem 0;text-align:right;"
    "border-bottom:1px solid "
    "var(--line);font-variant-numeric:tabular-nums;white-space:nowrap}\n"
    "th{font-weight:600;color:var(--soft)}.w{text-align:left;white-space:normal}\n";

void pp_html_text(const char *text, FILE *out)
{
    char *whole = pp_format_utf8_repair(text);
    for (const char *p = whole ? whole : ""; *p; p++)
        switch (*p) {
        case '&':
            fputs("&amp;", out);
            break;
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        case '"':
            fputs("&quot;", out);
            break;
        default:
            fputc(*p, out);
        }
    free(whole);
}

void pp_html_begin(const char *title, const char *more_style, FILE *out)
{
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
          "<title>",
          out);
    pp_html_text(title, out);
    fprintf(out, "</title>\n<style>\n%s%s</style>\n</head>\n<body>\n", style,
            more_style);
}

void pp_html_end(FILE *out)
{
    fputs("</body>\n</html>\n", out);
}
