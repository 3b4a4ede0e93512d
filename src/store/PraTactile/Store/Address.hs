{-# OPTIONS_HADDOCK hide #-}

-- | The address of a database on a server, in either form of libpq. A URI is
-- @postgresql://[USER[:PASSWORD]@][HOST[:PORT][,...]][/NAME][?PARAMETER=VALUE[&...]]@, where
-- special characters are percent-encoded. Settings are @host=HOST dbname=NAME@ and so on, with
-- apostrophes around values that contain blanks.
--
-- Only this module decides how a database's name is shown: never with a password. It reads both
-- forms slightly more strictly than libpq. A malformed address may have a password anywhere, so
-- little of it is shown.
module PraTactile.Store.Address
  ( -- * Addresses
    isAddress,
    Address,
    readAddress,
    unknownScheme,
    connectionString,

    -- * Showing addresses
    shownName,
    shownAddress,
    withheld,
  )
where

import Data.Char
  ( chr,
    digitToInt,
    isAlpha,
    isAlphaNum,
    isAscii,
    isControl,
    isDigit,
    isHexDigit,
    isSpace,
    toLower,
  )
import Data.List (inits, intercalate, isPrefixOf, isSuffixOf, stripPrefix, tails)
import Data.Maybe (fromMaybe, listToMaybe, mapMaybe)

-- | An address in its parts.
data Address
  = AsUri Uri
  | -- | keys and values, in their order
    AsSettings [(String, String)]

-- | A URI in its parts, as written.
data Uri = Uri
  { scheme :: String,
    user :: Maybe String,
    password :: Maybe String,
    hosts :: String,
    -- | with its slash, or empty
    path :: String,
    parameters :: [(String, String)]
  }

-- | Whether a name means an address and not a file: it has a scheme, begins with a libpq setting,
-- or has a password among settings.
isAddress :: String -> Bool
isAddress name =
  meansPostgres name || hasScheme || beginsWithKey || not (null (secretsFrom name))
  where
    hasScheme = maybe False (notElem '/' . fst) (breakOn "://" name)
    beginsWithKey = case span isKeyLetter (dropWhile isSpace name) of
      (key, rest) -> map toLower key `elem` keys && take 1 (dropWhile isSpace rest) == "="
    keys = words "host hostaddr port user dbname service passfile sslmode"

-- | Whether a name begins like a PostgreSQL address, possibly misspelt.
meansPostgres :: String -> Bool
meansPostgres name = any (`isPrefixOf` beyond) [":", "//"]
  where
    beyond = maybe "" (dropWhile isAlpha) (stripPrefix "postgres" begin)
    begin = map toLower (dropWhile isSpace name)

-- | The scheme of a name, if it has one that no address has.
unknownScheme :: String -> Maybe String
unknownScheme name = do
  (begin, _) <- breakOn "://" name
  if not (null begin)
    && all (\c -> isAscii c && (isAlphaNum c || c `elem` "+.-")) begin
    && map toLower begin `notElem` schemes
    then Just begin
    else Nothing

schemes :: [String]
schemes = ["postgresql", "postgres"]

-- | Reads an address in either form.
readAddress :: String -> Maybe Address
readAddress name = case breakOn "://" name of
  Just (begin, text)
    | map toLower begin `elem` schemes -> AsUri <$> readUri begin text
  _
    | isAddress name -> AsSettings <$> readSettings name
    | otherwise -> Nothing

readUri :: String -> String -> Maybe Uri
readUri begin text = do
  let (authority, beyond) = break (`elem` "/?") text
      (path', query) = break (== '?') beyond
      (credentials, hosts') = case breakAt '@' authority of
        Just (before, after) -> (Just before, after)
        Nothing -> (Nothing, authority)
  parameters' <- traverse parameter (filter (not . null) (pieces '&' (drop 1 query)))
  let uri =
        Uri
          { scheme = begin,
            user = takeWhile (/= ':') <$> credentials,
            password = credentials >>= fmap snd . breakAt ':',
            hosts = hosts',
            path = path',
            parameters = parameters'
          }
  if any isControl text
    || not (encodes text)
    || any ('@' `elem`) (hosts' : path' : map snd parameters')
    || '/' `elem` drop 1 path'
    || not (all host (pieces ',' hosts'))
    then Nothing
    else Just uri
  where
    parameter one = do
      (key, value) <- breakAt '=' one
      if not (null key) && all isKeyLetter key then Just (key, value) else Nothing
    -- Each percent sign precedes the hexadecimal digits of a byte other than 0.
    encodes rest = case dropWhile (/= '%') rest of
      _ : a : b : others -> isHexDigit a && isHexDigit b && [a, b] /= "00" && encodes others
      other -> null other
    -- A name or a number, then optionally a port.
    host one = case one of
      '[' : inner -> all isDigit (dropPort (drop 1 (dropWhile (/= ']') inner)))
      _ -> all isDigit (dropPort (dropWhile (/= ':') one))
    dropPort one = if take 1 one == ":" then drop 1 one else one

-- | Reads settings by libpq's rules (its function conninfo_parse).
readSettings :: String -> Maybe [(String, String)]
readSettings text
  | any (\c -> isControl c && not (isSpace c)) text = Nothing
  | otherwise = go (dropWhile isSpace text)
  where
    go [] = Just []
    go given = do
      let (key, rest) = span isKeyLetter given
      after <- if null key then Nothing else stripPrefix "=" (dropWhile isSpace rest)
      (value, others) <- case dropWhile isSpace after of
        '\'' : inner -> quotedValue inner
        inner -> Just (plainValue inner)
      ((key, value) :) <$> go (dropWhile isSpace others)
    plainValue inner = case inner of
      '\\' : c : others -> taking c (plainValue others)
      c : others | not (isSpace c) -> taking c (plainValue others)
      _ -> ("", inner)
    quotedValue inner = case inner of
      '\\' : c : others -> taking c <$> quotedValue others
      '\'' : others -> Just ("", others)
      c : others -> taking c <$> quotedValue others
      [] -> Nothing
    taking c (value, others) = (c : value, others)

isKeyLetter :: Char -> Bool
isKeyLetter c = isAscii c && (isAlpha c || c == '_')

-- | The address for libpq, with the given parameters added unless it has its own.
connectionString :: [(String, String)] -> Address -> String
connectionString usual address = case address of
  AsUri uri ->
    rendered
      uri
        { scheme = map toLower (scheme uri),
          parameters = parameters uri ++ beside (parameters uri)
        }
  AsSettings own -> unwords [key ++ "=" ++ setting value | (key, value) <- own ++ beside own]
  where
    beside own = [one | one <- usual, fst one `notElem` map fst own]

-- | A quoted value.
setting :: String -> String
setting value = "'" ++ concatMap escaped value ++ "'"
  where
    escaped c = if c `elem` "'\\" then ['\\', c] else [c]

-- | A database's name for messages, without a password. Passwords are removed from any other text
-- as well.
shownName :: String -> String
shownName name = case readAddress name of
  Just address -> shownAddress address
  Nothing
    | meansPostgres name -> "postgresql://..."
    | otherwise -> cutSecrets name

-- | An address for messages: without the password, and with only those parameters that identify
-- the database.
shownAddress :: Address -> String
shownAddress address = case address of
  AsUri uri ->
    rendered
      uri
        { user = shownValue "user" <$> user uri,
          password = Nothing,
          hosts = shownValue "host" (hosts uri),
          path = shownValue "dbname" (path uri),
          parameters =
            [(key, shownValue key value) | (key, value) <- parameters uri, isTelling key]
        }
  AsSettings settings
    | null told -> "postgresql://"
    | otherwise -> unwords [key ++ "=" ++ blankless (shownValue key value) | (key, value) <- told]
    where
      told = filter (isTelling . fst) settings
  where
    blankless value = if null value || any isSpace value then setting value else value

-- | The parts of an address, beside passwords, that must not be shown, as written and decoded:
-- values that are not shown in full, and keys after a password, which may be part of it.
withheld :: Address -> [String]
withheld address = filter (not . null) (concatMap bothWays hidden ++ suspects)
  where
    hidden = [value | (key, value) <- shownParts, isTelling key, shownValue key value /= value]
    (shownParts, keyed) = case address of
      AsUri uri ->
        ( [("user", name) | Just name <- [user uri]]
            ++ [("host", hosts uri), ("dbname", drop 1 (path uri))]
            ++ parameters uri,
          map fst (parameters uri)
        )
      AsSettings settings -> (settings, map fst settings)
    suspects = drop 1 (dropWhile (not . isSecret) keyed)
    bothWays value = [value, decoded value]

-- | Whether a parameter identifies the database.
isTelling :: String -> Bool
isTelling =
  (`elem` words "host hostaddr port user dbname service options application_name sslmode")

-- | Whether a key holds a password, under any name.
isSecret :: String -> Bool
isSecret key =
  lower == "pass"
    || any (`isPrefixOf` lower) ["passw", "pasw", "passphrase", "pgpass", "pwd"]
    || any (`isSuffixOf` lower) ["password", "passwd", "pwd", "secret"]
  where
    lower = map toLower key

-- | The value of a parameter for messages. A colon may belong to a numeric address or precede a
-- port; text after any other colon may be a password.
shownValue :: String -> String -> String
shownValue key value = cutAtColon (key `elem` ["host", "hostaddr"]) (cutSecrets value)

-- | Removes possible passwords from any text: what stands between a colon and the last at sign,
-- what follows a colon in an address without an at sign, and what follows a password's key.
cutSecrets :: String -> String
cutSecrets text = case breakOn "://" text of
  Just (begin, rest)
    | all (`notElem` ":@/") begin ->
      cutValues (begin ++ "://" ++ cutAtColon True (cutCredentials rest))
  _ -> cutValues (cutCredentials text)
  where
    cutValues given = case secretsFrom given of
      at : _ -> take at given ++ "..."
      [] -> given
    cutCredentials given = case (filter isColon (parted given), filter isAt (parted given)) of
      ((before, _) : _, ats@(_ : _))
        | (_, end) <- last ats,
          length end < length given - length before ->
          before ++ ":..." ++ end
      _ -> given
    isAt (_, rest) = any (`isPrefixOf` rest) ["@", "%40"]
    isColon (_, rest) = any (`isPrefixOf` map toLower (take 3 rest)) [":", "%3a"]

-- | Removes what follows a text's first colon, unless it is a numeric address or, where a port is
-- allowed, the colon precedes one. The colon may be encoded.
cutAtColon :: Bool -> String -> String
cutAtColon withPort text
  | byNumbers = text
  | otherwise = fromMaybe text (listToMaybe (mapMaybe cut (parted text)))
  where
    byNumbers =
      all (\c -> isHexDigit c || c `elem` ":.,[]/") text && length (filter (== ':') text) > 1
    cut (before, rest)
      | ':' : after <- rest,
        take 3 after /= "...",
        not (withPort && isPort after) =
        Just (before ++ ":...")
      | "%3a" `isPrefixOf` map toLower (take 3 rest) = Just (before ++ ":...")
      | otherwise = Nothing
    isPort after = case span isDigit after of
      (_ : _, end) -> take 1 end `elem` ["", ",", "/"]
      _ -> False

-- | All ways to split a text in two.
parted :: String -> [(String, String)]
parted text = zip (inits text) (tails text)

-- | The indices at which values of passwords begin, each after its key and an equals sign.
secretsFrom :: String -> [Int]
secretsFrom text =
  [ length text - length value
    | (before, rest) <- zip (Nothing : map Just text) (tails text),
      maybe True (not . isKeyLetter) before,
      (key, after) <- [span isKeyLetter rest],
      isSecret key,
      Just value <- [stripPrefix "=" (dropWhile isSpace after)],
      not (null value)
  ]

rendered :: Uri -> String
rendered uri =
  concat
    [ scheme uri,
      "://",
      maybe "" (++ maybe "@" (\secret -> ":" ++ secret ++ "@") (password uri)) (user uri),
      hosts uri,
      path uri,
      if null (parameters uri) then "" else "?",
      intercalate "&" [key ++ "=" ++ value | (key, value) <- parameters uri]
    ]

-- | Decodes percent-encoded characters, one byte each.
decoded :: String -> String
decoded text = case text of
  '%' : a : b : rest
    | isHexDigit a && isHexDigit b -> chr (16 * digitToInt a + digitToInt b) : decoded rest
  c : rest -> c : decoded rest
  [] -> []

-- | The text before and after the first occurrence of a character.
breakAt :: Char -> String -> Maybe (String, String)
breakAt letter = breakOn [letter]

-- | The text before and after the first occurrence of a word.
breakOn :: String -> String -> Maybe (String, String)
breakOn word text =
  listToMaybe
    [(before, rest) | (before, from) <- parted text, Just rest <- [stripPrefix word from]]

pieces :: Char -> String -> [String]
pieces letter text = case breakAt letter text of
  Just (before, after) -> before : pieces letter after
  Nothing -> [text]
