/* cmd_serve.c - the command serve: the drawing board in a browser, and an interface in
 * JSON. */
#include "config.h"

#include <spawn.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "model/base/read_file.h"
#include "serve/serve.h"
#include "serve/serve_address.h"

extern char **environ;

static const char about[] =
    "Serves the drawing board: a web page on which you draw a room and see its "
    "daylight at once. The command prints the page's address and runs until it is "
    "interrupted. The page opens with FILE, a room file, or with an example. Other "
    "programs can use the same server as a JSON interface, which docs/http.md "
    "describes.";

struct token_place {
    const char *text, *file;
};

struct serve_choice {
    long port;
    bool open;
    const char *listen, *jobs;
    struct token_place token;
    struct pp_serve_options serve; /* the options set only the allowed hosts */
};

static enum pp_status read_port(const char *text, void *place, struct pp_error *err)
{
    long port;
    if (pp_options_read_count(text, &port, NULL) != PP_OK || port > 65535)
        return pp_fail(err, PP_BAD_INPUT, "a port from 1 to 65535");
    *(long *)place = port;
    return PP_OK;
}

static enum pp_status read_host(const char *text, void *place, struct pp_error *err)
{
    struct pp_serve_options *serve = place;
    if (!*text || strlen(text) > 200 || strchr(text, ':') || strchr(text, '/'))
        return pp_fail(err, PP_BAD_INPUT, "the name of a host, without a port");
    if (serve->host_count == PP_SERVE_HOSTS_MOST)
        return pp_fail(err, PP_BAD_INPUT, "at most %d hosts", PP_SERVE_HOSTS_MOST);
    serve->hosts[serve->host_count++] = text;
    return PP_OK;
}

static const struct pp_option address_options[] = {
    {"port", 'p', "N", "Listen on this port (default: any free port).", read_port,
     offsetof(struct serve_choice, port)},
    {"open", 0, NULL, "Open the page in the browser.", NULL,
     offsetof(struct serve_choice, open)},
    {"listen", 0, "ADDRESS",
     "Listen on this address (default 127.0.0.1, for this computer alone). Other "
     "addresses need a token.",
     pp_options_read_text, offsetof(struct serve_choice, listen)},
    {"host", 0, "NAME",
     "Also accept requests for this host name, for example behind a proxy. Repeat the "
     "option for more names.",
     read_host, offsetof(struct serve_choice, serve)},
    {"token", 0, "TEXT",
     "Answer only requests with this token of 16 characters or more. Other users of "
     "the computer can see it in the list of processes; use --token-file to avoid "
     "this.",
     pp_options_read_text, offsetof(struct serve_choice, token.text)},
    {"token-file", 0, "FILE",
     "Answer only requests with the token on the first line of FILE.",
     pp_options_read_input, offsetof(struct serve_choice, token.file)},
    {"jobs", 0, "FOLDER",
     "Accept jobs whose results are fetched later, and store them in FOLDER.",
     pp_options_read_text, offsetof(struct serve_choice, jobs)},
    {0},
};

static void init_serve(void *values)
{
    *(struct serve_choice *)values = (struct serve_choice){0};
}

static enum pp_status check_serve(void *values, char **words, int count,
                                  struct pp_error *err)
{
    const struct serve_choice *choice = values;
    bool has_token = choice->token.text || choice->token.file;
    struct stat folder;
    (void)words;
    if (count > 1)
        return pp_fail(err, PP_BAD_INPUT, "there are %d files; expected at most one",
                       count);
    if (choice->token.text && choice->token.file)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected one of --token and --token-file, not both");
    if (choice->listen && !pp_serve_address_is_loopback(choice->listen) && !has_token)
        return pp_fail(err, PP_BAD_INPUT,
                       "other computers can reach %.80s; expected --token-file FILE or "
                       "--token TEXT as well",
                       choice->listen);
    if (choice->jobs && (stat(choice->jobs, &folder) != 0 || !S_ISDIR(folder.st_mode)))
        return pp_fail(err, PP_BAD_INPUT, "--jobs: there is no folder \"%.200s\"",
                       choice->jobs);
    return PP_OK;
}

/* Reads the first line of the file with the token; the caller frees it. */
static enum pp_status read_token(char **token, const char *file, struct pp_error *err)
{
    enum { TOKEN_BYTES = 4096 };
    size_t length;
    enum pp_status status = pp_read_file(token, &length, file, TOKEN_BYTES, err);
    if (status == PP_OK)
        (*token)[strcspn(*token, "\r\n")] = '\0';
    return status;
}

/* Makes a key of 128 random bits, in hexadecimal. The page needs the key to load the
 * room with which the server was started. */
static bool make_key(char key[33])
{
    unsigned char bytes[16];
    if (getrandom(bytes, sizeof bytes, 0) != (ssize_t)sizeof bytes)
        return false;
    for (size_t i = 0; i < sizeof bytes; i++)
        snprintf(key + 2 * i, 3, "%02x", bytes[i]);
    return true;
}

struct served {
    const struct serve_choice *choice;
    const struct pp_serve_options *options;
};

static void open_browser(const char *address)
{
    const char *const words[] = {"xdg-open", address, NULL};
    pid_t child;
    if (posix_spawnp(&child, words[0], NULL, NULL, (char *const *)(uintptr_t)words,
                     environ)
        != 0)
        pp_message("xdg-open is not installed; open the address in a browser");
}

static void print_address(void *data, int port)
{
    const struct served *served = data;
    const char *host =
        served->options->address ? served->options->address : "127.0.0.1";
    bool is_six = strchr(host, ':') != NULL;
    char address[4400];
    int length = snprintf(address, sizeof address, "http://%s%s%s:%d/",
                          is_six ? "[" : "", host, is_six ? "]" : "", port);
    if (served->options->key)
        snprintf(address + length, sizeof address - (size_t)length, "#key=%s",
                 served->options->key);
    puts(address);
    fflush(stdout);
    if (!served->choice->open)
        return;
    if (served->options->token)
        snprintf(address + length, sizeof address - (size_t)length, "#token=%s",
                 served->options->token);
    open_browser(address);
}

static bool was_interrupted(void *data)
{
    (void)data;
    return pp_interrupt_came();
}

#ifdef HAVE_MICROHTTPD
static enum pp_status run_server(const struct pp_serve_options *options,
                                 struct pp_error *err)
{
    pp_interrupt_watch();
    return pp_serve_run(options, err);
}
#else
static enum pp_status run_server(const struct pp_serve_options *options,
                                 struct pp_error *err)
{
    (void)options;
    return pp_fail(err, PP_SYSTEM,
                   "this pepperpot was built without libmicrohttpd and cannot serve; "
                   "install libmicrohttpd (Debian: libmicrohttpd-dev) and build again");
}
#endif

static enum pp_exit run_serve(void *values, char **files, int count)
{
    enum { ROOM_BYTES = 1 << 20, TOKEN_LEAST = 16 };
    const struct serve_choice *choice = values;
    struct pp_serve_options options = choice->serve;
    struct served served = {choice, &options};
    struct pp_error err = {0};
    char *room = NULL, *token = NULL, key[33];
    enum pp_status status = PP_OK;
    options.address = choice->listen;
    options.port = (int)choice->port;
    options.token = choice->token.text;
    options.jobs = choice->jobs;
    options.program = "/proc/self/exe";
    options.ready = print_address;
    options.stop = was_interrupted;
    options.data = &served;
    if (count > 0)
        status = pp_read_file(&room, &options.room_length, files[0], ROOM_BYTES, &err);
    options.room = room;
    if (status == PP_OK && choice->token.file)
        status = read_token(&token, choice->token.file, &err);
    if (token)
        options.token = token;
    if (status == PP_OK && options.token && strlen(options.token) < TOKEN_LEAST)
        status = pp_fail(&err, PP_BAD_INPUT,
                         "the token has %zu characters; expected %d or more",
                         strlen(options.token), TOKEN_LEAST);
    if (room && !options.token && make_key(key))
        options.key = key;
    if (status == PP_OK)
        status = run_server(&options, &err);
    free(token);
    free(room);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

static void clear_serve(void *values)
{
    (void)values;
}

static const struct pp_option_group groups[] = {
    {"The server", address_options, 0},
    {0},
};

const struct pp_command pp_command_serve = {
    .name = "serve",
    .summary = "the drawing board in a browser, and a JSON interface",
    .operands = "[FILE]",
    .about = about,
    .groups = groups,
    .size = sizeof(struct serve_choice),
    .init = init_serve,
    .check = check_serve,
    .run = run_serve,
    .clear = clear_serve,
};
