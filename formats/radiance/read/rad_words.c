/* rad_words.c - see rad_words.h. */
#include "formats/radiance/read/rad_words.h"

#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"

static bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

enum pp_status pp_rad_words_fail(const struct pp_rad_words *words, int line,
                                 struct pp_error *err, const char *format, ...)
{
    char text[800];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return pp_fail(err, PP_BAD_INPUT, "%.200s:%d: %s", words->file, line, text);
}

enum pp_status pp_rad_words_locate(const struct pp_rad_words *words, int line,
                                   enum pp_status status, const struct pp_error *said,
                                   struct pp_error *err)
{
    if (status == PP_BAD_INPUT)
        return pp_rad_words_fail(words, line, err, "%.600s", said->message);
    return status == PP_OK ? PP_OK : pp_fail(err, status, "%s", said->message);
}

static void skip_line(struct pp_rad_words *words)
{
    const char *end = memchr(words->bytes + words->at, '\n', words->length - words->at);
    words->at = end ? (size_t)(end - words->bytes) : words->length;
}

/* Skips white space and comments to the next word or the end. */
static void skip_space(struct pp_rad_words *words)
{
    while (words->at < words->length) {
        char c = words->bytes[words->at];
        if (c == '#') {
            skip_line(words);
            continue;
        }
        if (!is_space(c))
            return;
        words->line += c == '\n' && words->line < INT_MAX;
        words->at++;
    }
}

/* The quote that begins the next word, which may then contain blanks; 0: no quote. A
 * lone quote at the end of the text is a word. */
static char word_quote(const struct pp_rad_words *words)
{
    char c = words->at + 1 < words->length ? words->bytes[words->at] : '\0';
    return c == '"' || c == '\'' ? c : '\0';
}

enum pp_status pp_rad_words_next(struct pp_rad_words *words, struct pp_rad_word *word,
                                 struct pp_error *err)
{
    skip_space(words);
    *word = (struct pp_rad_word){words->bytes + words->at, 0, words->line};
    const char quote = word_quote(words);
    if (quote)
        word->text = words->bytes + ++words->at;
    while (words->at < words->length
           && (quote ? words->bytes[words->at] != quote
                     : !is_space(words->bytes[words->at]))) {
        unsigned char c = (unsigned char)words->bytes[words->at];
        if (quote && c == '\n')
            return pp_rad_words_fail(words, word->line, err,
                                     "a quoted word does not end on its line");
        if ((c < 32 && !is_space((char)c)) || c == 127)
            return pp_rad_words_fail(words, word->line, err,
                                     "there is a character with code %d; expected text",
                                     c);
        if (word->length == PP_RAD_WORD_MOST)
            return pp_rad_words_fail(words, word->line, err,
                                     "a word has more than %d characters",
                                     PP_RAD_WORD_MOST);
        word->length++;
        words->at++;
    }
    words->at += quote && words->at < words->length;
    if (quote && word->length == 0)
        return pp_rad_words_fail(words, word->line, err, "a quoted word is empty");
    return PP_OK;
}

enum pp_status pp_rad_words_next_command(struct pp_rad_words *words, char **command,
                                         int *line, struct pp_error *err)
{
    *command = NULL;
    skip_space(words);
    *line = words->line;
    if (words->at >= words->length || words->bytes[words->at] != '!')
        return PP_OK;
    words->at++;
    size_t room = 64, count = 0;
    char *text = malloc(room);
    for (; text; words->at++) {
        bool ended = words->at >= words->length;
        char c = ended ? '\n' : words->bytes[words->at];
        if (c == '\0') {
            free(text);
            return pp_rad_words_fail(words, words->line, err,
                                     "there is a NUL byte; expected text");
        }
        if (c == '\n' && !ended)
            words->line++;
        if (c == '\n' && (ended || count == 0 || text[count - 1] != '\\'))
            break;
        if (c == '\n') {
            text[count - 1] = ' ';
            continue;
        }
        if (count + 2 > room) {
            char *grown = realloc(text, room *= 2);
            if (!grown)
                free(text);
            text = grown;
        }
        if (text)
            text[count++] = c == '\r' || c == '\t' ? ' ' : c;
    }
    if (!text)
        return pp_fail_memory(err);
    words->at += words->at < words->length;
    text[count] = '\0';
    *command = text;
    return PP_OK;
}

bool pp_rad_words_is(struct pp_rad_word word, const char *text)
{
    return strlen(text) == word.length && memcmp(word.text, text, word.length) == 0;
}

bool pp_rad_words_number(struct pp_rad_word word, double *value)
{
    char text[64];
    if (word.length == 0 || word.length >= sizeof text)
        return false;
    memcpy(text, word.text, word.length);
    text[word.length] = '\0';
    return pp_text_parse_number(text, value);
}
