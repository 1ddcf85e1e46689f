/* Starts gnuplot, waits, and hands on what it complained about (see plot.h). */
#include "results/plot.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/paths.h"

enum { OUTPUT_MAX = 8192 };

/* Reads all of `fd`, keeps the first OUTPUT_MAX - 1 bytes. */
static void read_output(int fd, char output[OUTPUT_MAX])
{
    size_t kept = 0;
    char block[1024];
    for (;;) {
        ssize_t n = read(fd, block, sizeof block);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            break;
        size_t room = OUTPUT_MAX - 1 - kept;
        size_t take = (size_t)n < room ? (size_t)n : room;
        memcpy(output + kept, block, take);
        kept += take;
    }
    output[kept] = '\0';
}

/* gnuplot echoes the line, points at the place with ^ and ends with "file" line 3: message. The last line that is not empty. */
static const char *last_line(char *text)
{
    size_t length = strlen(text);
    while (length > 0 && (text[length - 1] == '\n' || text[length - 1] == ' '))
        text[--length] = '\0';
    const char *newline = strrchr(text, '\n');
    return newline ? newline + 1 : text;
}

/* Numbers and messages as in C, whatever the user's language is. */
static char **environment_in_c(void)
{
    size_t n = 0;
    while (environ[n])
        n++;
    char **copy = malloc((n + 2) * sizeof *copy);
    if (!copy)
        return NULL;
    size_t kept = 0;
    for (size_t i = 0; i < n; i++)
        if (strncmp(environ[i], "LC_ALL=", 7) != 0)
            copy[kept++] = environ[i];
    static char language[] = "LC_ALL=C";
    copy[kept++] = language;
    copy[kept] = NULL;
    return copy;
}

static int start(pid_t *pid, int pipe_end[2], char *const argv[], struct rl_error *error)
{
    char **environment = environment_in_c();
    if (!environment)
        return rl_fail_memory(error, "gnuplot's environment");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, pipe_end[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipe_end[1], STDERR_FILENO);
    int code = posix_spawnp(pid, argv[0], &actions, NULL, argv, environment);
    posix_spawn_file_actions_destroy(&actions);
    free(environment);
    if (code == ENOENT)
        return rl_fail(error, RL_ERR_UNAVAILABLE,
                       "gnuplot: not found on the PATH; the report's plots need it");
    if (code != 0)
        return rl_fail(error, RL_ERR_UNAVAILABLE, "gnuplot: cannot be started: %s", strerror(code));
    return RL_OK;
}

/* What a script says with `exit status 3`; gnuplot itself ends with 1 on an error. */
enum { EXIT_NOTHING_TO_DRAW = 3 };

static int run_gnuplot(char *const argv[], const char *script, struct rl_error *error)
{
    int pipe_end[2];
    if (pipe2(pipe_end, O_CLOEXEC) != 0)
        return rl_fail(error, RL_ERR_SYSTEM, "gnuplot: cannot make a pipe: %s", strerror(errno));
    pid_t pid = 0;
    int status = start(&pid, pipe_end, argv, error);
    close(pipe_end[1]);
    if (status == RL_OK) {
        char output[OUTPUT_MAX];
        read_output(pipe_end[0], output);
        int ended = 0;
        while (waitpid(pid, &ended, 0) < 0 && errno == EINTR)
            continue;
        if (WIFEXITED(ended) && WEXITSTATUS(ended) == EXIT_NOTHING_TO_DRAW)
            status = rl_fail(error, RL_ERR_CHECK, "plots/%s: nothing to draw: no value is positive", script);
        else if (!WIFEXITED(ended) || WEXITSTATUS(ended) != 0)
            status = rl_fail(error, RL_ERR_SYSTEM, "plots/%s: gnuplot failed: %s", script, last_line(output));
    }
    close(pipe_end[0]);
    return status;
}

int rl_plot(const char *script, const char *const arguments[], struct rl_error *error)
{
    char relative[128], path[PATH_MAX], style[PATH_MAX];
    snprintf(relative, sizeof relative, "plots/%s", script);
    int status = rl_path_data(path, sizeof path, relative, error);
    if (status == RL_OK)
        status = rl_path_data(style, sizeof style, "plots/style.gp", error);
    if (status != RL_OK)
        return status;
    /* posix_spawn takes char *const, but does not write to the words. */
    char *argv[RL_PLOT_ARGUMENTS_MAX + 5] = {(char *)"gnuplot", (char *)"-c", path, style};
    for (size_t i = 0; i < RL_PLOT_ARGUMENTS_MAX && arguments[i]; i++)
        argv[4 + i] = (char *)arguments[i];
    return run_gnuplot(argv, script, error);
}
