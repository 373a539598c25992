/* basis_clauses.c - see basis_clauses.h. */
#include "reports/page/basis_clauses.h"

#include <stddef.h>
#include <string.h>

#include "model/base/text.h"

/* Length of the first clause of a text. */
static size_t clause_length(const char *text)
{
    const char *end = strstr(text, "; ");
    return end ? (size_t)(end - text) : strlen(text);
}

/* Start of the clause after the first one of a text; its end if there is none. */
static const char *next_clause(const char *text)
{
    const char *end = text + clause_length(text);
    return *end ? end + 2 : end;
}

static const char level_label[] = PP_BASIS_LEVEL ": ";
enum { LEVEL_LABEL = sizeof level_label - 1 }; /* its length */

static bool names_level(const char *clause)
{
    return strncmp(clause, level_label, LEVEL_LABEL) == 0;
}

static bool has_clause(const char *text, const char *clause, size_t length)
{
    for (; *text; text = next_clause(text))
        if (clause_length(text) == length && strncmp(text, clause, length) == 0)
            return true;
    return false;
}

/* Writes the clauses of a basis that all bases have in common, or the others. */
static void write_clauses(char text[PP_BASIS_CLAUSES], const char *const *bases,
                          int count, int index, bool common)
{
    text[0] = '\0';
    for (const char *clause = bases[index]; *clause; clause = next_clause(clause)) {
        const size_t length = clause_length(clause);
        bool everywhere = true;
        for (int i = 0; i < count; i++)
            everywhere &= has_clause(bases[i], clause, length);
        if (everywhere == common && !names_level(clause))
            pp_text_append(text, PP_BASIS_CLAUSES, "%s%.*s", text[0] ? "; " : "",
                           (int)length, clause);
    }
}

void pp_basis_clauses_common(char text[PP_BASIS_CLAUSES], const char *const *bases,
                             int count)
{
    text[0] = '\0';
    if (count > 0)
        write_clauses(text, bases, count, 0, true);
}

void pp_basis_clauses_own(char text[PP_BASIS_CLAUSES], const char *const *bases,
                          int count, int index)
{
    write_clauses(text, bases, count, index, false);
}

bool pp_basis_clauses_level(char text[PP_BASIS_CLAUSES], const char *basis)
{
    text[0] = '\0';
    for (const char *clause = basis; *clause; clause = next_clause(clause))
        if (names_level(clause)) {
            const char *level = clause + LEVEL_LABEL;
            pp_text_append(text, PP_BASIS_CLAUSES, "%.*s", (int)clause_length(level),
                           level);
            return true;
        }
    return false;
}
