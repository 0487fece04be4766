# SPDX-License-Identifier: MIT
#
# What is had from another Debian than this one: its packages without installing them, and whole systems in a folder. The mirror
# is the one of this machine's own package lists. Sourced by bash.

# This machine's Debian: "MIRROR CODENAME"; nothing where apt names none.
this_debian() {
    command -v apt-get >/dev/null 2>&1 || return 0
    apt-get indextargets --format '$(SITE) $(RELEASE) $(ORIGIN)' 2>/dev/null |
        awk '$3 == "Debian" && $2 !~ /[-\/]/ { print $1, $2; exit }'
}

# Fetches packages of another Debian into FOLDER and unpacks them in FOLDER/root; nothing of this machine changes, for apt has a
# state of its own in FOLDER. Prints each file's name; what went wrong goes to standard error.
unpack_packages() {  # unpack_packages FOLDER SUITE PACKAGE...
    local folder=$1 suite=$2 mirror file
    shift 2
    mirror=$(this_debian)
    [ -n "$mirror" ] || { echo "apt names no mirror of Debian" >&2 && return 1; }
    rm -rf "$folder" && mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial" "$folder/root" || return 1
    : >"$folder/status"
    printf 'deb [signed-by=%s] %s %s main\n' /usr/share/keyrings/debian-archive-keyring.gpg "${mirror% *}" "$suite" >"$folder/sources.list"
    cat >"$folder/apt.conf" <<END
Dir::State "$folder";
Dir::State::status "$folder/status";
Dir::State::lists "$folder/lists";
Dir::Cache "$folder/cache";
Dir::Etc::sourcelist "$folder/sources.list";
Dir::Etc::sourceparts "-";
Dir::Etc::preferences "-";
Dir::Etc::preferencesparts "-";
Acquire::Languages "none";
Acquire::Retries "1";
Acquire::http::Timeout "30";
APT::Sandbox::User "";
END
    (
        cd "$folder" && export APT_CONFIG=$folder/apt.conf &&
            apt-get update -qq && apt-get download -qq "$@"
    ) >"$folder/log" 2>&1 || { tail -n 1 "$folder/log" >&2 && return 1; }
    for file in "$folder"/*.deb; do
        dpkg-deb -x "$file" "$folder/root" && basename "$file" || return 1
    done
}
