-- | The address of a database on a server, in libpq's form:
-- @postgresql://[USER[:PASSWORD]@][HOST[:PORT][,...]][/NAME][?PARAMETER=VALUE[&...]]@. Whatever
-- means something there is percent-encoded elsewhere. An address that is not read by this grammar,
-- which is a little stricter than libpq's, is never shown: a password could be anywhere in it.
module PraTactile.Store.Address
  ( isAddress,
    Address,
    readAddress,
    shownAddress,
    connectionString,
  )
where

import Data.Char (isAsciiLower, isControl, isDigit)
import Data.List (intercalate, isPrefixOf, stripPrefix)
import Data.Maybe (listToMaybe, mapMaybe)

-- | An address in its parts, each as it was written.
data Address = Address
  { scheme :: String,
    user :: Maybe String,
    password :: Maybe String,
    hosts :: String,
    -- | with its slash, or nothing
    path :: String,
    parameters :: [(String, String)]
  }

-- | Whether a name is meant as an address and not as a file's.
isAddress :: String -> Bool
isAddress name = any (`isPrefixOf` name) schemes

schemes :: [String]
schemes = ["postgresql://", "postgres://"]

-- | The address, if it is one of the grammar.
readAddress :: String -> Maybe Address
readAddress name = do
  (begin, text) <- listToMaybe (mapMaybe (\one -> (,) one <$> stripPrefix one name) schemes)
  let (authority, beyond) = break (`elem` "/?") text
      (path', query) = break (== '?') beyond
      (credentials, hosts') = case breakAt '@' authority of
        Just (before, after) -> (Just before, after)
        Nothing -> (Nothing, authority)
  parameters' <- traverse parameter (filter (not . null) (pieces '&' (drop 1 query)))
  let address =
        Address
          { scheme = begin,
            user = fst . upTo ':' <$> credentials,
            password = credentials >>= fmap snd . breakAt ':',
            hosts = hosts',
            path = path',
            parameters = parameters'
          }
  if any isControl name
    || any ('@' `elem`) (hosts' : path' : map snd parameters')
    || '/' `elem` drop 1 path'
    || not (all host (pieces ',' hosts'))
    then Nothing
    else Just address
  where
    parameter text = do
      (key, value) <- breakAt '=' text
      if not (null key) && all (\c -> isAsciiLower c || c == '_') key
        then Just (key, value)
        else Nothing
    -- A name or a number, then perhaps a port.
    host text = case text of
      '[' : inner -> all isDigit (dropPort (drop 1 (dropWhile (/= ']') inner)))
      _ -> all isDigit (dropPort (dropWhile (/= ':') text))
    dropPort text = if take 1 text == ":" then drop 1 text else text

-- | The address as it is shown: without a password, and of the parameters those that tell which
-- database it is.
shownAddress :: Address -> String
shownAddress address =
  rendered
    address
      { password = Nothing,
        parameters = filter ((`elem` telling) . fst) (parameters address)
      }
  where
    telling = words "host hostaddr port user dbname service options application_name sslmode"

-- | The address for libpq, with these parameters where it has no others of their names.
connectionString :: [(String, String)] -> Address -> String
connectionString usual address =
  rendered address {parameters = own ++ [one | one <- usual, fst one `notElem` map fst own]}
  where
    own = parameters address

rendered :: Address -> String
rendered address =
  concat
    [ scheme address,
      maybe "" (++ maybe "@" (\secret -> ":" ++ secret ++ "@") (password address)) (user address),
      hosts address,
      path address,
      if null (parameters address) then "" else "?",
      intercalate "&" [key ++ "=" ++ value | (key, value) <- parameters address]
    ]

upTo :: Char -> String -> (String, String)
upTo letter = break (== letter)

-- | What is before the first of these letters, and what is after it.
breakAt :: Char -> String -> Maybe (String, String)
breakAt letter text = case upTo letter text of
  (before, _ : after) -> Just (before, after)
  _ -> Nothing

pieces :: Char -> String -> [String]
pieces letter text = case breakAt letter text of
  Just (before, after) -> before : pieces letter after
  Nothing -> [text]
