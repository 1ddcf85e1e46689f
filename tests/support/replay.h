/* Runs one input of a fuzzer's harness in a process of its own, without the fuzzer, and says how that ended.
 *
 *     char why[128];
 *     if (!replay(why, sizeof why, LLVMFuzzerTestOneInput, "tests/fuzz/corpus/scene/empty", 20))
 *         printf("not ok - %s\n", why);
 */
#ifndef RL_TESTS_REPLAY_H
#define RL_TESTS_REPLAY_H

#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/files.h"

typedef int replay_harness(const uint8_t *data, size_t size);

/* Exit codes of a child: those of sanitizers (1) and of a program that is not found (127) are others. */
enum { REPLAY_UNREADABLE = 3, REPLAY_REFUSED = 4 };

/* The input lies in memory of exactly its size, so that a sanitizer sees what is read behind its end. exit, not _exit: leaks are looked for
 * then. */
static inline _Noreturn void replay_child(replay_harness *harness, const char *path, unsigned seconds)
{
    struct rl_error error;
    char *text;
    size_t size;
    signal(SIGALRM, SIG_DFL);
    alarm(seconds);
    if (rl_file_read(&text, &size, path, &error) != RL_OK) {
        fprintf(stderr, "%s\n", error.message);
        exit(REPLAY_UNREADABLE);
    }
    uint8_t *data = malloc(size ? size : 1);
    if (!data)
        exit(REPLAY_UNREADABLE);
    memcpy(data, text, size);
    free(text);
    int status = harness(data, size);
    free(data);
    exit(status == 0 ? 0 : REPLAY_REFUSED);
}

/* True: it came back by itself, within so many seconds, and no sanitizer had anything to say. Else `why`. */
static inline bool replay(char *why, size_t size, replay_harness *harness, const char *path, unsigned seconds)
{
    fflush(NULL);
    pid_t child = fork();
    if (child == 0)
        replay_child(harness, path, seconds);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) {
        snprintf(why, size, "no process could be started");
        return false;
    }
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
        snprintf(why, size, "not done after %u s", seconds);
    else if (WIFSIGNALED(status))
        snprintf(why, size, "%s", strsignal(WTERMSIG(status)));
    else if (WEXITSTATUS(status) == REPLAY_UNREADABLE)
        snprintf(why, size, "the file cannot be read");
    else if (WEXITSTATUS(status) != 0)
        snprintf(why, size, "exit code %d", WEXITSTATUS(status));
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

#endif
