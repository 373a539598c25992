/* document_html.c - see document_html.h. */
#include "reports/page/document_html.h"

#include <stdbool.h>
#include <string.h>

#include "reports/page/html.h"

static const char more_style[] =
    "td{vertical-align:top}th{white-space:normal;vertical-align:bottom}"
    "td.l{text-align:left;color:var(--soft);width:8rem}"
    ".wide+.wide{margin-top:1.5rem}th.g{color:var(--ink);padding-top:.7rem}code{"
    "overflow-wrap:anywhere}\n"
    "figure{margin:1rem 0}"
    "figure svg{width:100%;height:auto;background:#fff;border:1px solid var(--line)}"
    "figcaption{color:var(--soft);font-size:.9rem}\n"
    "@media print{body{max-width:none;padding:0;font-size:10pt}section+section{"
    "break-before:page}.wide{overflow:visible}tr,figure,.verdict{break-inside:avoid}"
    "figure svg{width:auto;max-width:100%;max-height:10.5cm}"
    "h2,h3,.g,.r td,tr:nth-child(-n+2){break-after:avoid}}\n";

/* Value of the attribute "class" for a cell, by the kind of column and the tone; NULL:
 * no attribute. */
static const char *class_of(enum pp_document_column_kind kind, enum pp_tone tone)
{
    const bool is_number = kind == PP_COLUMN_NUMBERS;
    if (tone == PP_TONE_GOOD)
        return is_number ? "good" : "w good";
    if (tone == PP_TONE_BAD)
        return is_number ? "bad" : "w bad";
    return kind == PP_COLUMN_WORDS ? "w" : kind == PP_COLUMN_LABELS ? "l" : NULL;
}

static void put_head(const struct pp_document_table *table, FILE *out)
{
    fputs("<thead><tr>", out);
    for (int i = 0; i < table->column_count; i++) {
        bool number = table->columns[i].kind == PP_COLUMN_NUMBERS;
        fputs(number ? "<th>" : "<th class=\"w\">", out);
        pp_html_text(table->columns[i].heading, out);
        fputs("</th>", out);
    }
    fputs("</tr></thead>\n", out);
}

static void put_across(const struct pp_document_table *table,
                       const struct pp_document_row *row, FILE *out)
{
    bool group = row->kind == PP_ROW_GROUP;
    fprintf(out,
            group ? "<tr><th class=\"w g\" colspan=\"%d\">"
                  : "<tr class=\"r\"><td class=\"w soft\" colspan=\"%d\">",
            table->column_count);
    pp_html_text(row->cell_count ? row->cells[0].text : "", out);
    fputs(group ? "</th></tr>\n" : "</td></tr>\n", out);
}

static void put_cells(const struct pp_document_table *table,
                      const struct pp_document_row *row, FILE *out)
{
    fputs("<tr>", out);
    for (int i = 0; i < table->column_count; i++) {
        if (i >= row->cell_count) {
            fputs("<td></td>", out);
            continue;
        }
        const struct pp_document_cell *cell = &row->cells[i];
        const char *class = class_of(table->columns[i].kind, cell->tone);
        fprintf(out, class ? "<td class=\"%s\">" : "<td>", class);
        pp_html_text(cell->text, out);
        if (cell->note) {
            fputs("<br><span class=\"soft\">", out);
            pp_html_text(cell->note, out);
            fputs("</span>", out);
        }
        fputs("</td>", out);
    }
    fputs("</tr>\n", out);
}

static void put_table(const struct pp_document_table *table, FILE *out)
{
    fputs("<div class=\"wide\"><table>\n", out);
    if (pp_document_has_head(table))
        put_head(table, out);
    for (int i = 0; i < table->row_count; i++)
        (table->rows[i].kind == PP_ROW_CELLS ? put_cells
                                             : put_across)(table, &table->rows[i], out);
    fputs("</table></div>\n", out);
}

static void put_picture(const struct pp_document_block *block,
                        const struct pp_svg_picture *picture, FILE *out)
{
    /* Omits the XML declaration, which is not allowed within an HTML page. */
    const char *svg = memmem(picture->bytes, picture->length, "<svg", 4);
    fputs("<figure>", out);
    if (svg)
        fwrite(svg, 1, picture->length - (size_t)(svg - picture->bytes), out);
    fputs("<figcaption>", out);
    pp_html_text(block->text, out);
    fputs("</figcaption></figure>\n", out);
}

static void put_paragraph(const struct pp_document_block *block, FILE *out)
{
    static const char *const openings[] = {
        [PP_TONE_PLAIN] = "<p>",
        [PP_TONE_SOFT] = "<p class=\"soft\">",
        [PP_TONE_GOOD] = "<p class=\"good\">",
        [PP_TONE_BAD] = "<p class=\"bad\">",
        [PP_TONE_VERDICT] = "<p class=\"verdict\">",
        [PP_TONE_CODE] = "<p><code>",
    };
    fputs(openings[block->tone], out);
    pp_html_text(block->text, out);
    fputs(block->tone == PP_TONE_CODE ? "</code></p>\n" : "</p>\n", out);
}

/* Writes a heading. *chapters: number of chapters so far, updated; the anchor of a
 * chapter has its number. */
static void put_heading(const struct pp_document_block *block, int *chapters, FILE *out)
{
    if (block->level == 2) {
        fputs(*chapters > 0 ? "</section>\n<section>\n" : "<section>\n", out);
        fprintf(out, "<h2 id=\"chapter-%d\">", ++*chapters);
    } else {
        fprintf(out, "<h%d>", block->level);
    }
    pp_html_text(block->text, out);
    fprintf(out, "</h%d>\n", block->level);
}

/* Writes links to the chapters. */
static void put_contents(const struct pp_document *document, FILE *out)
{
    int chapter = 0;
    fputs("<nav><ul>\n", out);
    for (int i = 0; i < document->block_count; i++) {
        const struct pp_document_block *block = &document->blocks[i];
        if (block->kind != PP_BLOCK_HEADING || block->level != 2)
            continue;
        fprintf(out, "<li><a href=\"#chapter-%d\">", ++chapter);
        pp_html_text(block->text, out);
        fputs("</a></li>\n", out);
    }
    fputs("</ul></nav>\n", out);
}

static void put_block(const struct pp_document *document, int index,
                      const struct pp_svg_picture *pictures, int *chapters, FILE *out)
{
    const struct pp_document_block *block = &document->blocks[index];
    switch (block->kind) {
    case PP_BLOCK_HEADING:
        put_heading(block, chapters, out);
        break;
    case PP_BLOCK_CONTENTS:
        put_contents(document, out);
        break;
    case PP_BLOCK_PARAGRAPH:
        put_paragraph(block, out);
        break;
    case PP_BLOCK_TABLE:
        put_table(&block->table, out);
        break;
    case PP_BLOCK_PICTURE:
        put_picture(block, &pictures[block->picture], out);
        break;
    }
}

void pp_document_html(const struct pp_document *document, const char *title,
                      const struct pp_svg_picture *pictures, FILE *out)
{
    int chapters = 0;
    pp_html_begin(title, more_style, out);
    for (int i = 0; i < document->block_count; i++)
        put_block(document, i, pictures, &chapters, out);
    fputs(chapters > 0 ? "</section>\n" : "", out);
    pp_html_end(out);
}
